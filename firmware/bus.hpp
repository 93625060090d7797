#pragma once

#include <concepts>
#include <cstddef>
#include <span>

namespace kfast {

// Compound requirements would be torn apart.
// clang-format off

/// The wires to a display controller with a data/command line (D/C).
template <class B>
concept DisplayBus = requires(B& bus, std::span<const std::byte> bytes) {
    /// Sends all of `bytes` with D/C low before it returns. Not while busy().
    { bus.command(bytes) } -> std::same_as<void>;
    /// Starts to send `bytes` with D/C high and returns; they must stay as they are until busy() is false.
    /// Not while busy().
    { bus.start_data(bytes) } -> std::same_as<void>;
    { bus.busy() } -> std::same_as<bool>;
};

// clang-format on

}
