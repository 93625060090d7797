#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// The boot loader of a chip, which gives a computer access to its flash. What it speaks is chosen at run
/// time, hence virtual. Addresses are those of the chip's memory map.
///
/// All members throw Failure: with unplugged, with timed_out, and with refused when the boot loader says no.
class BootLoader {
public:
    BootLoader() = default;
    virtual ~BootLoader() = default;
    BootLoader(const BootLoader&) = delete;
    BootLoader& operator=(const BootLoader&) = delete;

    /// Of whole pages of 256 bytes.
    virtual void read(std::uint32_t address, std::span<std::byte> bytes) = 0;
    /// Of whole sectors of 4 KiB.
    virtual void erase(std::uint32_t address, std::size_t bytes) = 0;
    /// Of whole pages that are erased; in the order of their addresses.
    virtual void write(std::uint32_t address, std::span<const std::byte> bytes) = 0;
    /// Starts what lies in flash. The boot loader is gone then.
    virtual void restart() = 0;
};

}
