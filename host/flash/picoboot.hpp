#pragma once

#include "host/flash/boot_loader.hpp"
#include "host/flash/usb_pipe.hpp"

#include <cstdint>
#include <memory>
#include <span>

namespace kfast {

/// The boot loader in the ROM of an RP2040, which speaks PICOBOOT. From the beginning to the end of its life
/// nobody else writes to flash: the drive of the boot loader takes no files.
class PicobootLoader final : public BootLoader {
public:
    /// Frees the boot loader from what another program may have left unfinished, and takes it over. Throws as
    /// all members do.
    explicit PicobootLoader(std::unique_ptr<UsbPipe> pipe);
    ~PicobootLoader() override;

    void read(std::uint32_t address, std::span<std::byte> bytes) override;
    void erase(std::uint32_t address, std::size_t bytes) override;
    void write(std::uint32_t address, std::span<const std::byte> bytes) override;
    void restart() override;

private:
    struct Command;

    void reset();
    void begin(const Command& command, std::size_t bytes);
    void finish();
    void run(const Command& command, std::span<const std::byte> data = {});
    void fetch(const Command& command, std::span<std::byte> data);
    [[noreturn]] void throw_refusal(const Command& command);

    std::unique_ptr<UsbPipe> pipe_;
    std::uint32_t token_ = 0; ///< of the last command
    bool is_gone_ = false;    ///< it was restarted
};

}
