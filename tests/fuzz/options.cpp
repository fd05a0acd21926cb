// Reads the command line; see options.h.
#include "fuzz/options.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

namespace terrazzo::fuzz {
namespace {

constexpr const char* kUsage = R"(usage: fuzz --library FILE [OPTION...]
Calls the library's commands with seeded arguments, in child processes; a failure prints how to repeat it.
  --system NAME       who makes contexts: osmesa, egl or glx (osmesa)
  --seed N            of the first episode (1)
  --calls N           end after so many calls
  --seconds N         end after so many seconds
  --episodes N        end after so many episodes
  --operations N      operations of an episode and thread (1000)
  --threads N         threads that use one share group (1)
  --only REGEX        leave out commands of other names
  --call-seconds N    a call that takes longer hangs (30)
  --failures N        end after so many failures (3)
  --here              run in this process, for a debugger; ends at the first failure
  --trace             print the calls, with --here
  --minimise          find the fewest operations of episode --seed that fail, and print their calls
  --keep FILE         only the operations whose numbers the file lists (thread * 2^20 + index)
)";

[[noreturn]] void refuse(const char* what) {
    std::fprintf(stderr, "fuzz: %s\n%s", what, kUsage);
    std::exit(2);
}

std::vector<std::uint64_t> read_numbers(const char* name) {
    std::ifstream file(name);
    std::vector<std::uint64_t> numbers{std::istream_iterator<std::uint64_t>(file),
                                       std::istream_iterator<std::uint64_t>()};
    if (numbers.empty()) refuse("the file of --keep has no numbers");
    std::ranges::sort(numbers);
    return numbers;
}

}  // namespace

Options parse_options(int count, char** arguments) {
    Options out;
    for (int i = 1; i < count; ++i) {
        const std::string_view name = arguments[i];
        if (name == "--help") std::fputs(kUsage, stdout), std::exit(0);
        if (name == "--here")
            out.here = true;
        else if (name == "--trace")
            out.episode.trace = true;
        else if (name == "--minimise")
            out.minimise = true;
        else if (++i == count)
            refuse("an option is unknown or lacks its value");
        else if (name == "--library")
            out.library = arguments[i];
        else if (name == "--only")
            out.only = arguments[i];
        else if (name == "--keep")
            out.episode.keep = read_numbers(arguments[i]);
        else if (name == "--system")
            out.episode.system = arguments[i];
        else {
            char* end = nullptr;
            const std::uint64_t number = std::strtoull(arguments[i], &end, 10);
            if (*end != 0 || end == arguments[i]) refuse("a value is no number");
            if (name == "--seed")
                out.seed = number;
            else if (name == "--calls")
                out.calls = number;
            else if (name == "--seconds")
                out.seconds = number;
            else if (name == "--episodes")
                out.episodes = number;
            else if (name == "--operations")
                out.episode.operations = std::min(number, kThreadStride - 1);
            else if (name == "--threads")
                out.episode.threads = static_cast<unsigned>(std::clamp<std::uint64_t>(number, 1, 16));
            else if (name == "--call-seconds")
                out.episode.seconds_per_call = static_cast<unsigned>(number);
            else if (name == "--failures")
                out.failures = static_cast<unsigned>(number);
            else if (name == "--report")
                out.report = static_cast<int>(number);
            else
                refuse("an option is unknown");
        }
    }
    if (out.library.empty()) refuse("--library is missing");
    return out;
}

}  // namespace terrazzo::fuzz
