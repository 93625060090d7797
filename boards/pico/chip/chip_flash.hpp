#pragma once

#include "boards/pico/chip/flash.hpp"
#include "firmware/settings/rp2040_flash.hpp"
#include "firmware/slots/flash.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::pico {

/// The flash of the chip as slots have it. The watchdog is fed before a sector is erased.
class ChipFlash {
public:
    void erase(std::uint32_t offset) const { flash::erase(offset, kfast::sector_bytes); }
    void program(std::uint32_t offset, std::span<const std::byte, kfast::page_bytes> page) const
    {
        flash::program(offset, page);
    }
    std::span<const std::byte> contents() const { return flash::contents(); }
};

static_assert(Flash<ChipFlash>);

}
