#pragma once

#include "host/flash/boot_board.hpp"
#include "host/program/failure.hpp"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace kfast {

/// The device refuses a transfer: it stalls.
class UsbStall : public Failure {
public:
    UsbStall() : Failure{"the device refuses a USB transfer", ExitStatus::refused} {}
};

/// An interface of a USB device that no other program has meanwhile, with a bulk endpoint in each
/// direction. Its implementation is chosen at run time, hence virtual.
///
/// All members throw UsbStall, and Failure with unplugged (the device is gone or the cable bad) and
/// timed_out.
class UsbPipe {
public:
    UsbPipe() = default;
    virtual ~UsbPipe() = default;
    UsbPipe(const UsbPipe&) = delete;
    UsbPipe& operator=(const UsbPipe&) = delete;

    /// Sends all of them; a packet without bytes if there are none.
    virtual void send(std::span<const std::byte> bytes, std::chrono::milliseconds patience) = 0;
    /// Returns how many came: fewer where the device ended the transfer with a short packet. There is room
    /// for one byte at least.
    virtual std::size_t receive(std::span<std::byte> bytes, std::chrono::milliseconds patience) = 0;

    /// Vendor requests to the interface. The second returns how many bytes came.
    virtual void control_write(std::uint8_t request, std::chrono::milliseconds patience) = 0;
    virtual std::size_t ask(std::uint8_t request, std::span<std::byte> answer,
                            std::chrono::milliseconds patience) = 0;

    /// Clears the halt of those endpoints that are halted.
    virtual void clear_halts() = 0;
};

/// The boot loader in the ROM of an RP2040, which speaks PICOBOOT. From the beginning to the end of its life
/// nothing else writes to flash: the drive of the boot loader takes no files. After a transfer that has
/// failed, the next command takes control anew, for the boot loader may be in the middle of the one before.
class PicobootLoader final : public BootLoader {
public:
    /// Frees the boot loader from what another program may have left unfinished, and takes control. Throws as
    /// all members do.
    explicit PicobootLoader(std::unique_ptr<UsbPipe> pipe);
    ~PicobootLoader() override;

    void read(std::uint32_t address, std::span<std::byte> bytes) override;
    void erase(std::uint32_t address, std::size_t bytes) override;
    void write(std::uint32_t address, std::span<const std::byte> bytes) override;
    void restart() override;

private:
    struct Command;

    void take_control();
    void reset();
    void begin(const Command& command, std::size_t bytes);
    void finish();
    void run(const Command& command, std::span<const std::byte> data = {});
    void fetch(const Command& command, std::span<std::byte> data);
    [[noreturn]] void throw_refusal(const Command& command);

    std::unique_ptr<UsbPipe> pipe_;
    std::uint32_t token_ = 0;  ///< of the last command
    bool has_control_ = false; ///< it waits for a command, and nothing else writes to flash
    bool is_gone_ = false;     ///< it was restarted
};

}
