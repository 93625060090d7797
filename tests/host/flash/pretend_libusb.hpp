#pragma once

#include "tests/host/flash/boot_rom.hpp"

#include <cstdint>
#include <map>
#include <vector>

namespace kfast::test {

/// What is plugged in for those who ask the libusb of this program, which takes the place of the real one.
struct PluggedIn {
    std::uint16_t vendor = 0x2e8a;
    std::uint16_t product = 0x0003;
    std::uint8_t bus = 1;
    std::uint8_t address = 5;
    std::vector<std::uint8_t> ports{2, 3};
    bool has_drive = true;    ///< as its first interface, before that of PICOBOOT
    bool has_picoboot = true; ///< as its last one
    BootRom* rom = nullptr;   ///< what the interface of PICOBOOT leads to
    int open_error = 0;       ///< of LIBUSB_ERROR_..., or none
    int claim_error = 0;
    int transfer_error = 0; ///< of the next bulk transfers
};

/// Those of this program; looked at when libusb is begun.
inline std::vector<PluggedIn> plugged_in;

/// Of what was begun, opened and claimed and has not been given back.
inline int libusb_things_in_use = 0;

}
