#pragma once

#include "host/flash/picoboot.hpp"
#include "tests/host/flash/nor_flash.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace kfast::test {

/// The PICOBOOT interface of an RP2040 as its boot ROM has it, for one who is strict: it stalls as the ROM
/// does, and lets a transfer wait for ever that comes when it expects another.
class BootRom {
public:
    static constexpr std::size_t never = std::numeric_limits<std::size_t>::max();

    explicit BootRom(NorFlash& flash) : flash_{flash} {}

    void send(std::span<const std::byte> bytes);
    std::size_t receive(std::span<std::byte> bytes);
    void control_write(std::uint8_t request);
    std::size_t ask(std::uint8_t request, std::span<std::byte> answer);
    /// Standard requests to an endpoint.
    bool is_halted(bool in) const { return in ? in_is_halted_ : out_is_halted_; }
    void clear_halt(bool in);

    /// Transfers, and within them sectors that are erased and pages that are written.
    std::size_t steps = 0;
    std::size_t unplugged_after = never; ///< so many steps
    /// What the next command that has data is to be refused with: INTERLEAVED_WRITE and the like.
    std::optional<std::uint32_t> next_status;
    bool goes_at_once = false; ///< without acknowledging a restart

    int exclusive = 0; ///< as EXCLUSIVE_ACCESS was told
    bool is_ejected = false;
    bool has_left_xip = false;
    std::optional<std::array<std::uint32_t, 3>> restart; ///< program counter, stack pointer, delay in ms

private:
    enum class Phase { command, data_out, data_in, acknowledge_in, acknowledge_out };

    void step();
    void halt_both();
    void take_command(std::span<const std::byte> packet);
    std::uint32_t refusal_of_range() const;
    void start();
    void erase();
    void take_data(std::span<const std::byte> bytes);

    NorFlash& flash_;
    Phase phase_ = Phase::command;
    bool out_is_halted_ = false;
    bool in_is_halted_ = false;
    std::uint32_t token_ = 0;
    std::uint32_t status_ = 0;
    std::uint32_t id_ = 0;
    std::uint32_t length_ = 0; ///< of the data that follow
    std::array<std::uint32_t, 4> arguments_{};
    std::vector<std::byte> page_; ///< of data that came
};

/// What a computer has of it.
class BootRomPipe final : public UsbPipe {
public:
    explicit BootRomPipe(BootRom& rom) : rom_{rom} {}

    void send(std::span<const std::byte> bytes, std::chrono::milliseconds) override { rom_.send(bytes); }
    std::size_t receive(std::span<std::byte> bytes, std::chrono::milliseconds) override
    {
        return rom_.receive(bytes);
    }
    void control_write(std::uint8_t request, std::chrono::milliseconds) override
    {
        rom_.control_write(request);
    }
    std::size_t ask(std::uint8_t request, std::span<std::byte> answer, std::chrono::milliseconds) override
    {
        return rom_.ask(request, answer);
    }
    void clear_halts() override
    {
        rom_.clear_halt(false);
        rom_.clear_halt(true);
    }

private:
    BootRom& rom_;
};

}
