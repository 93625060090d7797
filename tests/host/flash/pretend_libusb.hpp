#pragma once

#include "tests/host/flash/boot_rom.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace kfast::test {

/// An interface of a device, as its descriptor tells.
struct PretendInterface {
    std::uint8_t kind = 0;
    bool has_setting = true;
    std::vector<std::pair<std::uint8_t, std::uint8_t>> endpoints; ///< addresses and attributes
};

/// What is plugged in for those who ask the libusb of this program, which takes the place of the real one.
struct PluggedIn {
    std::uint16_t vendor = 0x2e8a;
    std::uint16_t product = 0x0003;
    std::uint8_t bus = 1;
    std::uint8_t address = 5;
    std::vector<std::uint8_t> ports{2, 3};
    bool has_drive = true;    ///< as its first interface, before that of PICOBOOT
    bool has_picoboot = true; ///< as its last one
    std::optional<std::vector<PretendInterface>> interfaces{}; ///< instead of these two
    BootRom* rom = nullptr;                                    ///< what the interface of PICOBOOT leads to
    int configuration_error = 0;
    int open_error = 0; ///< of LIBUSB_ERROR_..., or none
    int claim_error = 0;
    int transfer_error = 0; ///< of the next bulk transfers
};

/// Those of this program; looked at when libusb is begun.
inline std::vector<PluggedIn> plugged_in;

/// What comes of a transfer instead of what the ROM makes of it: the number of bytes that it moves, to be put
/// into `bytes` if the device sends them, or an error.
using TransferChange =
    std::function<int(bool is_in, std::span<std::byte> bytes, const std::function<int()>& by_rom)>;

/// None: transfers are as the ROM makes them.
inline TransferChange changed_transfer;

/// Of what was begun, opened and claimed and has not been given back.
inline int libusb_things_in_use = 0;

}
