#pragma once

#include "firmware/bus.hpp"
#include "firmware/microseconds.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// One row of a panel's start-up table.
struct StartUpStep {
    std::uint8_t command = 0;
    std::uint8_t argument_count = 0;
    std::array<std::uint8_t, 8> arguments{};
    Microseconds wait{}; ///< to let pass after the command
};

/// Sends the table; a command goes out together with its arguments, all with D/C low.
/// `pause(Microseconds)` returns when that time has passed.
template <DisplayBus Bus, class Pause>
void send_start_up(Bus& bus, std::span<const StartUpStep> table, Pause& pause)
{
    for (const StartUpStep& step : table) {
        std::array<std::byte, 1 + std::tuple_size_v<decltype(step.arguments)>> bytes{std::byte{step.command}};
        std::ranges::transform(step.arguments, bytes.begin() + 1,
                               [](auto value) { return std::byte{value}; });
        bus.command(std::span{bytes}.first(1u + step.argument_count));
        if (step.wait != Microseconds{})
            pause(step.wait);
    }
}

}
