#include "boards/pico/chip/flash.hpp"

#include "boards/pico/chip/boot_rom.hpp"
#include "boards/pico/chip/interrupts.hpp"
#include "boards/pico/chip/pins.hpp"
#include "boards/pico/chip/register.hpp"
#include "boards/pico/chip/watchdog.hpp"
#include "firmware/settings/rp2040_flash.hpp"

#include <algorithm>
#include <array>

extern "C" {
// From the linker script.
extern const std::uint32_t flash_begin[];
}

namespace kfast::pico::flash {
namespace {

/// While it lives flash takes commands and cannot be read: what happens meanwhile is in RAM, as all code of
/// the image is but the first of start.cpp.
class CommandMode {
public:
    CommandMode()
    {
        for (std::size_t word = 0; word < boot_block_.size(); ++word)
            boot_block_[word] = flash_begin[word];
        connect_();
        leave_reading_();
    }
    ~CommandMode()
    {
        flush_cache_();
        set_up_reading();
    }
    CommandMode(const CommandMode&) = delete;
    CommandMode& operator=(const CommandMode&) = delete;

private:
    using Step = void();

    void set_up_reading()
    {
        asm volatile("" ::: "memory"); // the copy is complete
        constexpr std::uintptr_t thumb = 1;
        reinterpret_cast<Step*>(reinterpret_cast<std::uintptr_t>(boot_block_.data()) | thumb)();
    }

    InterruptsOff guard_;
    std::array<std::uint32_t, 64> boot_block_; // with the code that lets flash be read again
    Step* connect_ = boot_rom::function<Step>('I', 'F');
    Step* leave_reading_ = boot_rom::function<Step>('E', 'X');
    Step* flush_cache_ = boot_rom::function<Step>('F', 'C');
};

// The unit that communicates with the flash chip (SSI); in command mode the boot ROM has set it up for bytes,
// one in for each one out.
constexpr Register ssi_sr{0x1800'0028};
constexpr Register ssi_dr0{0x1800'0060};
constexpr std::uint32_t ssi_sr_rfne = 1 << 3;

// GPIO_QSPI_SS_CTRL of IO_QSPI: the pin that selects the flash chip is forced low or high, as the unit would
// let go of it whenever it has nothing to send. The boot ROM does the same; flushing the cache ends that.
constexpr Register gpio_qspi_ss_ctrl{0x4001'800C};
constexpr std::uint32_t outover_from_low_to_high = gpio_ctrl_outover_low ^ gpio_ctrl_outover_high;

/// While it lives the flash chip takes what is sent as one command.
class Selected {
public:
    Selected()
    {
        gpio_qspi_ss_ctrl.set(gpio_ctrl_outover_low);
        gpio_qspi_ss_ctrl.clear(outover_from_low_to_high);
    }
    ~Selected() { gpio_qspi_ss_ctrl.set(outover_from_low_to_high); }
    Selected(const Selected&) = delete;
    Selected& operator=(const Selected&) = delete;
};

/// Sends a byte, and returns what the chip sent meanwhile.
std::byte exchange(std::uint8_t byte)
{
    ssi_dr0.write(byte);
    while ((ssi_sr.read() & ssi_sr_rfne) == 0) {
    }
    return static_cast<std::byte>(ssi_dr0.read());
}

void expect(bool is_kept)
{
    if (!is_kept)
        __builtin_trap();
}

bool lies_in_ram(const void* place) { return reinterpret_cast<std::uintptr_t>(place) >> 28 == 2; }

void erase_sector(std::uint32_t offset)
{
    using Erase =
        void(std::uint32_t offset, std::size_t count, std::uint32_t block_bytes, std::uint32_t block_command);
    auto* const erase = boot_rom::function<Erase>('R', 'E');
    constexpr std::uint32_t block_bytes = 1 << 16;
    constexpr std::uint32_t erase_block = 0xD8;
    const CommandMode mode;
    erase(offset, sector_bytes, block_bytes, erase_block);
}

}

void erase(std::uint32_t offset, std::size_t count)
{
    expect(offset % sector_bytes == 0 && count % sector_bytes == 0);
    for (const auto end = static_cast<std::uint32_t>(offset + count); offset != end; offset += sector_bytes) {
        watchdog::feed();
        erase_sector(offset);
    }
}

void program(std::uint32_t offset, std::span<const std::byte> bytes)
{
    using Program = void(std::uint32_t offset, const std::byte* bytes, std::size_t count);
    expect(offset % page_bytes == 0 && bytes.size() % page_bytes == 0 && lies_in_ram(bytes.data()));
    auto* const program = boot_rom::function<Program>('R', 'P');
    const CommandMode mode;
    program(offset, bytes.data(), bytes.size());
}

std::span<const std::byte> contents()
{
    return std::as_bytes(std::span{flash_begin, rp2040::flash_bytes / sizeof(std::uint32_t)});
}

UniqueId unique_id()
{
    constexpr std::uint8_t read_unique_id = 0x4B;
    constexpr int silent_bytes = 4; // after the command
    const CommandMode mode;
    const Selected selected;
    exchange(read_unique_id);
    for (int i = 0; i < silent_bytes; ++i)
        exchange(0);
    UniqueId id;
    std::ranges::generate(id, [] { return exchange(0); });
    return id;
}

}
