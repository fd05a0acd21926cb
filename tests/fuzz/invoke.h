// Calls a function of any of the registry's signatures with values that were drawn.
#pragma once

#include <type_traits>
#include <utility>

#include "fuzz/table.h"

namespace terrazzo::fuzz {

template <typename T>
T value_as(const Value& value) {
    if constexpr (std::is_pointer_v<T>) {
        return reinterpret_cast<T>(value.pointer);
    } else if constexpr (std::is_floating_point_v<T>) {
        return static_cast<T>(value.real);
    } else {
        return static_cast<T>(value.integer);
    }
}

template <typename Result, typename... Arguments>
std::int64_t invoke(Function function, [[maybe_unused]] const Value* values) {
    const auto call = [&]<std::size_t... kIndices>(std::index_sequence<kIndices...>) {
        return reinterpret_cast<Result (*)(Arguments...)>(function)(value_as<Arguments>(values[kIndices])...);
    };
    if constexpr (std::is_integral_v<Result>) {
        return static_cast<std::int64_t>(call(std::index_sequence_for<Arguments...>()));
    } else {
        call(std::index_sequence_for<Arguments...>());
        return 0;
    }
}

}  // namespace terrazzo::fuzz
