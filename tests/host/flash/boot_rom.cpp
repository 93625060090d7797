#include "tests/host/flash/boot_rom.hpp"

#include "core/bytes/byte_reader.hpp"
#include "host/compiler/pack/byte_writer.hpp"

#include <algorithm>

namespace kfast::test {
namespace {

constexpr std::uint32_t flash_begin = 0x1000'0000;
constexpr std::uint32_t flash_end = 0x2000'0000;

enum Status : std::uint32_t { ok, unknown_command, wrong_length, wrong_transfer, no_address, unaligned };

struct Form {
    std::uint32_t id;
    std::uint32_t argument_bytes;
    bool has_data;
};

constexpr std::array forms{Form{0x01, 1, false}, Form{0x02, 12, false}, Form{0x03, 8, false},
                           Form{0x84, 8, true},  Form{0x05, 8, true},   Form{0x06, 0, false}};

}

void BootRom::step()
{
    if (steps == unplugged_after)
        throw Failure{"unplugged", ExitStatus::unplugged};
    ++steps;
}

void BootRom::halt_both()
{
    out_is_halted_ = true;
    in_is_halted_ = true;
    phase_ = Phase::command;
}

void BootRom::send(std::span<const std::byte> bytes)
{
    step();
    if (out_is_halted_)
        throw UsbStall{};
    switch (phase_) {
    case Phase::command:
        return take_command(bytes);
    case Phase::data_out:
        return take_data(bytes);
    case Phase::acknowledge_out:
        phase_ = bytes.empty() ? Phase::command : throw std::logic_error{"an acknowledgement has no bytes"};
        return;
    default:
        throw Failure{"the ROM waits for the computer to fetch something", ExitStatus::timed_out};
    }
}

std::size_t BootRom::receive(std::span<std::byte> bytes)
{
    step();
    if (in_is_halted_)
        throw UsbStall{};
    if (phase_ == Phase::acknowledge_in) {
        phase_ = Phase::command;
        if (restart && goes_at_once)
            throw Failure{"gone", ExitStatus::unplugged};
        return 0;
    }
    if (phase_ != Phase::data_in)
        throw Failure{"the ROM has nothing to tell", ExitStatus::timed_out};
    const std::size_t count = std::min<std::size_t>(bytes.size(), length_);
    std::ranges::copy(flash_.read(arguments_[0], count), bytes.begin());
    arguments_[0] += static_cast<std::uint32_t>(count);
    length_ -= static_cast<std::uint32_t>(count);
    if (length_ == 0)
        phase_ = Phase::acknowledge_out;
    return count;
}

void BootRom::take_command(std::span<const std::byte> packet)
{
    ByteReader reader{packet};
    if (packet.size() != 32 || reader.u32() != 0x431F'D10B)
        return halt_both();
    token_ = reader.u32();
    id_ = reader.u8();
    const std::uint32_t argument_bytes = reader.u8();
    reader.skip(2);
    length_ = reader.u32();
    std::ranges::generate(arguments_, [&reader] { return reader.u32(); });
    const auto* const form = std::ranges::find(forms, id_, &Form::id);
    if (form == forms.end())
        status_ = unknown_command;
    else if (argument_bytes != form->argument_bytes)
        status_ = wrong_length;
    else if (length_ != (form->has_data ? arguments_[1] : 0))
        status_ = wrong_transfer;
    else
        return start();
    halt_both();
}

std::uint32_t BootRom::refusal_of_range() const
{
    if (next_status)
        return *next_status;
    if (arguments_[0] < flash_begin || arguments_[0] + length_ > flash_end)
        return no_address;
    if (arguments_[0] % NorFlash::page_bytes != 0)
        return unaligned;
    return has_left_xip ? ok : throw std::logic_error{"flash cannot be reached before EXIT_XIP"};
}

void BootRom::start()
{
    status_ = ok;
    phase_ = Phase::acknowledge_in;
    switch (id_) {
    case 0x01:
        exclusive = static_cast<int>(arguments_[0]);
        is_ejected = is_ejected || exclusive == 2;
        return;
    case 0x02:
        restart = {arguments_[0], arguments_[1], arguments_[2]};
        return;
    case 0x03:
        return erase();
    case 0x06:
        has_left_xip = true;
        return;
    default:
        break;
    }
    status_ = refusal_of_range();
    page_.clear();
    phase_ = id_ == 0x05 ? Phase::data_out : Phase::data_in;
    in_is_halted_ = status_ != ok && phase_ == Phase::data_in;
}

/// The ROM drops the status of an erasure, and acknowledges it.
void BootRom::erase()
{
    const std::uint32_t end = arguments_[0] + arguments_[1];
    if (arguments_[0] % NorFlash::sector_bytes != 0 || arguments_[1] % NorFlash::sector_bytes != 0 ||
        arguments_[0] < flash_begin || end > flash_end || !has_left_xip)
        return;
    for (std::uint32_t address = arguments_[0]; address < end; address += NorFlash::sector_bytes) {
        step();
        flash_.erase_sector(address);
    }
}

void BootRom::take_data(std::span<const std::byte> bytes)
{
    for (const std::byte byte : bytes) {
        page_.push_back(byte);
        --length_;
        if (page_.size() < NorFlash::page_bytes && length_ > 0)
            continue;
        step();
        if (status_ != ok) {
            out_is_halted_ = true;
            throw UsbStall{};
        }
        page_.resize(NorFlash::page_bytes, std::byte{0x5A}); // what the buffer held before
        flash_.program_page(arguments_[0], page_);
        arguments_[0] += NorFlash::page_bytes;
        page_.clear();
    }
    if (length_ == 0)
        phase_ = Phase::acknowledge_in;
}

void BootRom::control_write(std::uint8_t request)
{
    step();
    if (request != 0x41)
        throw UsbStall{};
    out_is_halted_ = false;
    in_is_halted_ = false;
    phase_ = Phase::command;
    token_ = status_ = id_ = 0;
    exclusive = 0;
}

std::size_t BootRom::ask(std::uint8_t request, std::span<std::byte> answer)
{
    step();
    if (request != 0x42 || answer.size() != 16)
        throw UsbStall{};
    ByteWriter status;
    status.u32(token_);
    status.u32(status_);
    status.u32(id_);
    status.u32(0);
    std::ranges::copy(status.bytes(), answer.begin());
    return answer.size();
}

/// Which does not end what the ROM is at.
void BootRom::clear_halt(bool in)
{
    step();
    (in ? in_is_halted_ : out_is_halted_) = false;
}

}
