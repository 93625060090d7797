#pragma once

#include "boards/pico/chip/pins.hpp"
#include "firmware/panel/bus.hpp"
#include "firmware/settings/board_settings.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::pico {

/// A display on an 8080 bus of eight bits, made by a state machine of PIO0. The data is taken when WR rises.
/// CS goes low anew for every transfer and stays low after it. The display's RD is to be wired high.
class ParallelBus {
public:
    /// The settings keep all rules (board_rules.hpp) and are for a parallel bus. There is one bus. Needs
    /// start_clocks().
    explicit ParallelBus(const BoardSettings& settings);

    void command(std::span<const std::byte> bytes);
    void parameters(std::span<const std::byte> bytes);
    void start_data(std::span<const std::byte> bytes);
    void start_words(std::span<const std::byte> words);
    bool busy();

private:
    void select(std::uint32_t piece_bits);
    void send(std::span<const std::byte> bytes);

    OutputPin select_;
    OutputPin dc_;
    std::uint32_t piece_bits_ = 0;      ///< of what the state machine takes at once
    bool waits_for_last_write_ = false; ///< everything is in the state machine
};

static_assert(WordBus<ParallelBus>);

}
