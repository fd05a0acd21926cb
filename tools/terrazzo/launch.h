// Starting programs so that they load Terrazzo as libGL, libEGL, libOSMesa and libglvnd's vendor. Shared by
// `terrazzo run` and `terrazzo view`.
#pragma once

#include <string>
#include <vector>

namespace terrazzo {

// Changes this process's environment for the programs that it becomes or starts. threads < 0: as it was.
void use_terrazzo(int threads);
// exec: arguments[0] is the program, looked for in PATH. Says why when it cannot be, and ends this process
// with the status that a shell would give.
[[noreturn]] void become(const std::vector<std::string>& arguments);

}  // namespace terrazzo
