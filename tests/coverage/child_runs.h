// What this folder's tests share: a library drawn with in a process of its own, in one of its variants.
#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include "kit/child.h"

namespace terrazzo::coverage {

struct Renderer {
    const char* library;
    const char* threads;
    const char* isa;  // "": the best
};
inline constexpr Renderer kOurs{TERRAZZO_OWN_LIBRARY, "0", ""};
inline constexpr Renderer kThreaded{TERRAZZO_OWN_LIBRARY, "4", "scalar"};
inline constexpr Renderer kTheirs{TERRAZZO_REFERENCE_LIBRARY, "0", ""};

inline uint32_t number_from(const char* variable, uint32_t otherwise) {
    const char* const text = std::getenv(variable);
    return text ? static_cast<uint32_t>(std::strtoul(text, nullptr, 10)) : otherwise;
}

// What the task returns, which gets the library's path beside its arguments; null where the child failed.
inline nlohmann::json run_task(const char* task, const Renderer& renderer, nlohmann::json arguments) {
    arguments["library"] = renderer.library;
    kit::ChildRequest request{
        .executable = {},
        .task = task,
        .arguments = std::move(arguments),
        .environment = {{"LP_NUM_THREADS", "0"}, {"TERRAZZO_THREADS", renderer.threads}},
        .timeout = std::chrono::minutes(4)};
    if (*renderer.isa) request.environment.emplace_back("TERRAZZO_ISA", renderer.isa);
    const kit::ChildReport report = kit::run_in_child(request);
    EXPECT_TRUE(report.finished()) << renderer.library << ": " << report.message << '\n' << report.output;
    return report.finished() ? report.result : nlohmann::json();
}

}  // namespace terrazzo::coverage
