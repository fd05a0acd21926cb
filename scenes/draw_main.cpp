// The program that draws in a child process. It links nothing but libc and libstdc++, so that the time to the
// first frame and the peak memory that it reports are the GL library's.
#include <cstdio>

#include "draw_task.h"
#include "kit/child.h"
#include "small/small_task.h"
#include "states/state_task.h"

int main(int argc, char** argv) {
    int exit_code = 0;
    if (terrazzo::kit::serve_child(argc, argv,
                                   {{"draw", terrazzo::draw_task},
                                    {"info", terrazzo::info_task},
                                    {"small", terrazzo::small_frames::small_task},
                                    {"states", terrazzo::states::state_task}},
                                   &exit_code))
        return exit_code;
    std::fputs("terrazzo-draw is started by the terrazzo command.\n", stderr);
    return 2;
}
