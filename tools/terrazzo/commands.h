// The subcommands of `terrazzo`. Each adds itself to the command line and runs in its callback; a failure is
// an exception of CLI11's kind or std::runtime_error, reported by main.
#pragma once

#include <CLI/CLI.hpp>

namespace terrazzo {

void add_bench_command(CLI::App& app);
void add_states_command(CLI::App& bench_command);
void add_small_command(CLI::App& bench_command);
void add_info_command(CLI::App& app);
void add_draw_command(CLI::App& app);
void add_demo_command(CLI::App& app);
void add_run_command(CLI::App& app);
void add_view_command(CLI::App& app);

}  // namespace terrazzo
