#pragma once

#include <concepts>
#include <cstddef>
#include <span>

namespace kfast {

// Compound requirements would be torn apart.
// clang-format off

/// The wires to a display controller with a data/command line (D/C). Nothing is called while busy() but busy().
template <class B>
concept DisplayBus = requires(B& bus, std::span<const std::byte> bytes) {
    /// Sends all of `bytes` with D/C low before it returns.
    { bus.command(bytes) } -> std::same_as<void>;
    /// Sends all of `bytes` with D/C high before it returns: the parameters of a command.
    { bus.parameters(bytes) } -> std::same_as<void>;
    /// Starts to send `bytes` with D/C high and returns; they must stay as they are until busy() is false.
    { bus.start_data(bytes) } -> std::same_as<void>;
    { bus.busy() } -> std::same_as<bool>;
};

/// A bus that sends memory as 16-bit words, the high byte first: colours need not be stored in bus order.
template <class B>
concept WordBus = DisplayBus<B> && requires(B& bus, std::span<const std::byte> words) {
    /// Like start_data(). `words` is aligned to 2 and holds whole words, little-endian.
    { bus.start_words(words) } -> std::same_as<void>;
};

// clang-format on

}
