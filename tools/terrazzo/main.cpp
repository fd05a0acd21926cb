// terrazzo: runs programs on Terrazzo; measures, inspects and shows OSMesa libraries.
#include <fmt/core.h>

#include <filesystem>
#include <new>

#include "commands.h"

int main(int argc, char** argv) {
    CLI::App app{"Runs programs on Terrazzo; measures, inspects and shows software OpenGL libraries."};
    app.require_subcommand(1);
    terrazzo::add_bench_command(app);
    terrazzo::add_info_command(app);
    terrazzo::add_draw_command(app);
    terrazzo::add_demo_command(app);
    terrazzo::add_run_command(app);
    terrazzo::add_view_command(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& stop) {
        return app.exit(stop);
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "terrazzo: there is not enough memory\n");
        return 1;
    } catch (const std::filesystem::filesystem_error& failure) {
        fmt::print(stderr, "terrazzo: {}: {}\n", failure.path1().string(), failure.code().message());
        return 1;
    } catch (const std::exception& failure) {
        fmt::print(stderr, "terrazzo: {}\n", failure.what());
        return 1;
    }
    return 0;
}
