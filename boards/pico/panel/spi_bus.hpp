#pragma once

#include "boards/pico/chip/pins.hpp"
#include "firmware/panel/bus.hpp"
#include "firmware/settings/board_settings.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::pico {

/// A display on SPI0 or SPI1, whichever the clock pin belongs to, in mode 3. CS goes low anew for every
/// transfer and stays low after it; D/C and CS are any pins.
class SpiBus {
public:
    /// The settings keep all rules (board_rules.hpp) and are for SPI. There is one bus. Needs start_clocks().
    explicit SpiBus(const BoardSettings& settings);

    void command(std::span<const std::byte> bytes);
    void parameters(std::span<const std::byte> bytes);
    void start_data(std::span<const std::byte> bytes);
    void start_words(std::span<const std::byte> words);
    bool busy() const;

private:
    void select(std::uint32_t frame_bits) const;
    void send(std::span<const std::byte> bytes) const;

    int unit_;
    OutputPin select_;
    OutputPin dc_;
};

static_assert(WordBus<SpiBus>);

}
