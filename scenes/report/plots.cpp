// gnuplot reads its commands from a memory file and writes to a pipe.
#include "plots.h"

#include <fmt/core.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <stdexcept>

namespace terrazzo::report {
namespace {

struct Closing {
    void operator()(FILE* file) const { std::fclose(file); }
};

std::string output_of(const std::string& command) {
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) throw std::runtime_error("gnuplot cannot be started");
    std::string output;
    char buffer[4096];
    for (std::size_t count; (count = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;)
        output.append(buffer, count);
    const int status = pclose(pipe);
    if (status == 127 << 8)
        throw std::runtime_error("plots need gnuplot, which is not there (Debian: gnuplot-nox)");
    if (status != 0) throw std::runtime_error("gnuplot did not understand its commands");
    return output;
}

}  // namespace

std::string plot(std::string_view commands, int width, int height) {
    const std::unique_ptr<FILE, Closing> script(fdopen(memfd_create("gnuplot", 0), "w+"));
    if (!script) throw std::runtime_error("there is no memory for a plot");
    const std::string text = fmt::format(
        "set terminal svg size {},{} dynamic font 'system-ui,13'\n"
        "set border 3 linecolor rgb '#8a8378'\nset tics nomirror textcolor rgb '#8a8378'\n"
        "set key textcolor rgb '#8a8378'\nset xlabel textcolor rgb '#8a8378'\nset ylabel textcolor rgb "
        "'#8a8378'\n{}",
        width, height, commands);
    std::fwrite(text.data(), 1, text.size(), script.get());
    if (std::fflush(script.get()) != 0) throw std::runtime_error("there is no memory for a plot");
    std::string svg =
        output_of(fmt::format("gnuplot /proc/{}/fd/{} 2>/dev/null", getpid(), fileno(script.get())));
    // An element, not a file of its own.
    const std::size_t start = svg.find("<svg");
    if (start == std::string::npos) throw std::runtime_error("gnuplot drew nothing");
    return svg.substr(start);
}

}  // namespace terrazzo::report
