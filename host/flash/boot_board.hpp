#pragma once

#include "host/program/failure.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace kfast {

/// The boot loader of a chip, which gives a computer access to its flash. Its protocol is chosen at run
/// time, hence virtual. Addresses are those of the chip's memory map.
///
/// All members throw Failure: with unplugged, with timed_out, and with refused when the boot loader refuses.
class BootLoader {
public:
    BootLoader() = default;
    virtual ~BootLoader() = default;
    BootLoader(const BootLoader&) = delete;
    BootLoader& operator=(const BootLoader&) = delete;

    /// Reads whole pages of 256 bytes.
    virtual void read(std::uint32_t address, std::span<std::byte> bytes) = 0;
    /// Erases whole sectors of 4 KiB.
    virtual void erase(std::uint32_t address, std::size_t bytes) = 0;
    /// Writes whole pages that are erased; in the order of their addresses.
    virtual void write(std::uint32_t address, std::span<const std::byte> bytes) = 0;
    /// Starts what is in flash. The boot loader is gone then.
    virtual void restart() = 0;
};

/// The chips whose boot loaders are known.
enum class BootChip : std::uint8_t { rp2040, rp2350 };

/// A board whose boot loader waits at USB.
struct BootBoard {
    BootChip chip = BootChip::rp2040;
    /// Where it is plugged in, in the notation of Linux: "1-2.3". The only thing that identifies it: all
    /// RP2040 have the same serial number there.
    std::string port;

    friend bool operator==(const BootBoard&, const BootBoard&) = default;
};

/// The boards that are plugged in, in the order of their ports. Needs no permission.
std::vector<BootBoard> boards_in_boot_loader();

/// The boot loader was started without PICOBOOT: it is a drive, and nothing else.
class NoPicoboot : public Failure {
public:
    NoPicoboot()
        : Failure{
              "the boot loader was started without PICOBOOT: plug the board in anew with BOOTSEL held down",
              ExitStatus::refused}
    {
    }
};

/// Throws NoPicoboot, and Failure with no_permission, no_device (it is gone), wrong_chip, refused (another
/// program has it), and as BootLoader.
std::unique_ptr<BootLoader> open_boot_loader(const BootBoard& board);

}
