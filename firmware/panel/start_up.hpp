#pragma once

#include "firmware/chip/microseconds.hpp"
#include "firmware/panel/bus.hpp"

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// How a controller takes the arguments of its commands.
enum class Arguments : std::uint8_t {
    with_command,  ///< like the command, with D/C low
    as_parameters, ///< after it, with D/C high
};

/// Sends a command and its arguments: `bytes`, the command first.
template <Arguments how, DisplayBus Bus>
void send_command(Bus& bus, std::span<const std::byte> bytes)
{
    if constexpr (how == Arguments::with_command) {
        bus.command(bytes);
    } else {
        bus.command(bytes.first(1));
        if (bytes.size() > 1)
            bus.parameters(bytes.subspan(1));
    }
}

/// The same with numbers, of which the low byte is sent.
template <Arguments how, DisplayBus Bus>
void send_command(Bus& bus, int command, std::integral auto... arguments)
{
    send_command<how>(bus, std::array{static_cast<std::byte>(command), static_cast<std::byte>(arguments)...});
}

/// One row of a panel's start-up table.
struct StartUpStep {
    std::uint8_t command = 0;
    std::uint8_t argument_count = 0;
    std::array<std::uint8_t, 16> arguments{};
    Microseconds wait{}; ///< to let pass after the command
};

/// Sends the table row by row. `pause(Microseconds)` returns when that time has passed.
template <Arguments how, DisplayBus Bus, class Pause>
void send_start_up(Bus& bus, std::span<const StartUpStep> table, Pause& pause)
{
    for (const StartUpStep& step : table) {
        std::array<std::byte, 1 + std::tuple_size_v<decltype(step.arguments)>> bytes{std::byte{step.command}};
        std::ranges::transform(step.arguments, bytes.begin() + 1,
                               [](auto value) { return std::byte{value}; });
        send_command<how>(bus, std::span<const std::byte>{bytes}.first(1u + step.argument_count));
        if (step.wait != Microseconds{})
            pause(step.wait);
    }
}

}
