// PICOBOOT according to the published sources of the boot ROM (raspberrypi/pico-bootrom-rp2040,
// bootrom/usb_boot_device.c and async_task.c).
//
// A command is 32 bytes, then come the data, if there are any, then a packet without bytes in the direction
// opposite to that of the last phase. An invalid command stalls both endpoints, an error
// with data stalls theirs, until a reset; the status says what it was. An erasure that is not possible is
// acknowledged all the same: that flash was erased shows only when it is read.

#include "host/flash/picoboot.hpp"

#include "core/bytes/byte_reader.hpp"
#include "host/compiler/pack/byte_writer.hpp"
#include "host/flash/flash_image.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace kfast {

namespace {

using namespace std::chrono_literals;

constexpr std::uint32_t command_magic = 0x431F'D10B;
constexpr std::size_t command_bytes = 32;
constexpr std::size_t status_bytes = 16;
constexpr std::size_t packet_bytes = 64; ///< at most, of a bulk endpoint at full speed

constexpr std::uint8_t reset_request = 0x41;
constexpr std::uint8_t status_request = 0x42;

constexpr std::uint8_t exclusive_access_id = 0x01;
constexpr std::uint8_t reboot_id = 0x02;
constexpr std::uint8_t erase_id = 0x03;
constexpr std::uint8_t read_id = 0x84;
constexpr std::uint8_t write_id = 0x05;
constexpr std::uint8_t exit_xip_id = 0x06;

constexpr std::uint8_t without_the_drive = 1;
constexpr std::uint8_t with_ejected_drive = 2;

/// For a restart from flash, which is requested by the program counter 0.
constexpr std::uint32_t end_of_ram = 0x2004'2000;
constexpr std::uint32_t restart_after_milliseconds = 500;

/// A sector is erased in 0.4 s at worst; the rest is for computers that are busy.
constexpr auto patience = 10s;

struct StatusMeaning {
    std::uint32_t status;
    const char* meaning;
};

constexpr const char* own_mistake = "that is a mistake of kfast, please report it";

constexpr std::array status_meanings{
    StatusMeaning{1, "it does not know the command: is that a board with an RP2040?"},
    StatusMeaning{2, own_mistake},
    StatusMeaning{3, own_mistake},
    StatusMeaning{4, "it has no memory there: what is flashed belongs to another board"},
    StatusMeaning{5, own_mistake},
    StatusMeaning{6, "another program wrote to the drive of the board meanwhile: end that, and try again"},
    StatusMeaning{7, "it is about to restart: enter the boot loader again"},
    StatusMeaning{8, "it does not say why: plug the board in anew with BOOTSEL held down, and try again"},
};

std::string meaning_of(std::uint32_t status)
{
    const auto* const known = std::ranges::find(status_meanings, status, &StatusMeaning::status);
    if (known != status_meanings.end())
        return known->meaning;
    return "status " + std::to_string(status) +
           ": plug the board in anew with BOOTSEL held down, and try again";
}

std::vector<std::byte> words(std::initializer_list<std::uint32_t> values)
{
    ByteWriter arguments;
    for (const std::uint32_t value : values)
        arguments.u32(value);
    return arguments.bytes();
}

std::vector<std::byte> range(std::uint32_t address, std::size_t bytes)
{
    return words({address, static_cast<std::uint32_t>(bytes)});
}

}

struct PicobootLoader::Command {
    std::uint8_t id = 0;
    std::vector<std::byte> arguments;
    std::string words; ///< what it does, after "to"
};

PicobootLoader::PicobootLoader(std::unique_ptr<UsbPipe> pipe) : pipe_{std::move(pipe)} { take_control(); }

void PicobootLoader::take_control()
{
    reset();
    has_control_ = true;
    run({exclusive_access_id, {std::byte{without_the_drive}}, "let others wait"});
    run({exit_xip_id, {}, "open its flash"});
}

/// Lets others have the drive again.
PicobootLoader::~PicobootLoader()
{
    if (is_gone_)
        return;
    try {
        reset();
    } catch (const Failure&) { // the next program begins with a reset
    }
}

void PicobootLoader::read(std::uint32_t address, std::span<std::byte> bytes)
{
    fetch({read_id, range(address, bytes.size()), "read flash at " + hex_text(address)}, bytes);
}

void PicobootLoader::erase(std::uint32_t address, std::size_t bytes)
{
    constexpr std::uint32_t step = FlashImage::sector_bytes; // so that patience is for one
    for (const std::uint64_t end = std::uint64_t{address} + bytes; address < end; address += step)
        run({erase_id, range(address, step), "erase flash at " + hex_text(address)});
}

void PicobootLoader::write(std::uint32_t address, std::span<const std::byte> bytes)
{
    run({write_id, range(address, bytes.size()), "write to flash at " + hex_text(address)}, bytes);
}

/// Ejects the drive first: a computer complains of one that vanishes. The board may be gone before it
/// acknowledges the restart.
void PicobootLoader::restart()
{
    run({exclusive_access_id, {std::byte{with_ejected_drive}}, "eject its drive"});
    const Command reboot{reboot_id, words({0, end_of_ram, restart_after_milliseconds}), "restart"};
    bool is_sent = false;
    try {
        begin(reboot, 0);
        is_sent = true;
        finish();
    } catch (const Failure& failure) {
        has_control_ = false;
        if (!is_sent || failure.status() == ExitStatus::timed_out)
            throw;
    }
    is_gone_ = true;
}

void PicobootLoader::reset()
{
    pipe_->clear_halts();
    pipe_->control_write(reset_request, patience);
}

/// Sends a command. `bytes` of data follow.
void PicobootLoader::begin(const Command& command, std::size_t bytes)
{
    if (!has_control_)
        take_control();
    ByteWriter packet;
    packet.u32(command_magic);
    packet.u32(++token_);
    packet.u8(command.id);
    packet.u8(static_cast<std::uint32_t>(command.arguments.size()));
    packet.u16(0);
    packet.u32(static_cast<std::uint32_t>(bytes));
    packet.append(command.arguments);
    packet.append(std::vector<std::byte>(command_bytes - packet.size()));
    pipe_->send(packet.bytes(), patience);
}

/// Finishes a command that fetches nothing.
void PicobootLoader::finish()
{
    std::array<std::byte, packet_bytes> nothing{};
    if (pipe_->receive(nothing, patience) != 0)
        throw Failure{"the boot loader answers what nobody asked: plug the board in anew with BOOTSEL held "
                      "down, and try again",
                      ExitStatus::refused};
}

void PicobootLoader::run(const Command& command, std::span<const std::byte> data)
try {
    begin(command, data.size());
    if (!data.empty())
        pipe_->send(data, patience);
    finish();
} catch (const UsbStall&) {
    throw_refusal(command);
} catch (const Failure&) {
    has_control_ = false;
    throw;
}

void PicobootLoader::fetch(const Command& command, std::span<std::byte> data)
try {
    begin(command, data.size());
    for (std::span<std::byte> rest = data; !rest.empty();) {
        const std::size_t count = pipe_->receive(rest, patience);
        if (count == 0)
            throw Failure{"the boot loader ends before it has told all that it was asked to " +
                              command.words +
                              ": plug the board in anew with BOOTSEL held down, and try again",
                          ExitStatus::refused};
        rest = rest.subspan(count);
    }
    pipe_->send({}, patience);
} catch (const UsbStall&) {
    throw_refusal(command);
} catch (const Failure&) {
    has_control_ = false;
    throw;
}

void PicobootLoader::throw_refusal(const Command& command)
{
    has_control_ = false;
    std::array<std::byte, status_bytes> answer{};
    pipe_->ask(status_request, answer, patience);
    ByteReader reader{answer};
    const bool is_of_this = reader.u32() == token_;
    const std::uint32_t status = reader.u32();
    reset();
    throw Failure{"the boot loader refuses to " + command.words + ": " +
                      meaning_of(is_of_this ? status : std::uint32_t{8}),
                  ExitStatus::refused};
}

}
