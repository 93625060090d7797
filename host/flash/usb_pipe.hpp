#pragma once

#include "host/program/failure.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// The device refuses a transfer: it stalls.
class UsbStall : public Failure {
public:
    UsbStall() : Failure{"the device refuses a USB transfer", ExitStatus::refused} {}
};

/// An interface of a USB device that belongs to nobody else meanwhile, with a bulk endpoint in each
/// direction. What is behind it is chosen at run time, hence virtual.
///
/// All members throw UsbStall, and Failure with unplugged (the device is gone or the cable bad) and
/// timed_out.
class UsbPipe {
public:
    UsbPipe() = default;
    virtual ~UsbPipe() = default;
    UsbPipe(const UsbPipe&) = delete;
    UsbPipe& operator=(const UsbPipe&) = delete;

    /// All of them; a packet without bytes if there are none.
    virtual void send(std::span<const std::byte> bytes, std::chrono::milliseconds patience) = 0;
    /// Returns how many came: fewer where the device ended the transfer with a short packet. There is room
    /// for one byte at least.
    virtual std::size_t receive(std::span<std::byte> bytes, std::chrono::milliseconds patience) = 0;

    /// Vendor requests to the interface. The second returns how many bytes came.
    virtual void control_write(std::uint8_t request, std::chrono::milliseconds patience) = 0;
    virtual std::size_t ask(std::uint8_t request, std::span<std::byte> answer,
                            std::chrono::milliseconds patience) = 0;

    /// Of those endpoints that are halted.
    virtual void clear_halts() = 0;
};

}
