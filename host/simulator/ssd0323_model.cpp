#include "host/simulator/ssd0323_model.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace kfast {
namespace {

constexpr int memory_columns = 64;
constexpr int memory_rows = 80;

struct Command {
    std::uint8_t code;
    std::uint8_t parameters;
};

constexpr std::array commands{
    Command{0x15, 2}, Command{0x75, 2},                                     // window
    Command{0x81, 1}, Command{0x84, 0}, Command{0x85, 0}, Command{0x86, 0}, // brightness
    Command{0xA0, 1}, Command{0xA1, 1}, Command{0xA2, 1}, Command{0xA8, 1}, // geometry
    Command{0xA4, 0},                                                       // show the memory
    Command{0xAD, 1}, Command{0xAE, 0}, Command{0xAF, 0},                   // power
    Command{0xB1, 1}, Command{0xB2, 1}, Command{0xB3, 1}, Command{0xB8, 8}, // timing, grey table
    Command{0xBC, 1}, Command{0xBE, 1}, Command{0xBF, 1}, Command{0xE3, 0}, // voltages, nothing
};

std::string hex(std::uint8_t value)
{
    std::array<char, 5> text{};
    std::snprintf(text.data(), text.size(), "0x%02X", value);
    return text.data();
}

}

void Ssd0323Model::command(std::span<const std::byte> bytes)
{
    for (const std::byte byte : bytes) {
        if (!error_)
            take_command(std::to_integer<std::uint8_t>(byte));
        ++position_;
    }
}

void Ssd0323Model::data(std::span<const std::byte> bytes)
{
    for (const std::byte byte : bytes) {
        if (!error_)
            take_data(std::to_integer<std::uint8_t>(byte));
        ++position_;
    }
}

std::array<std::uint8_t, Ssd0323Model::width * Ssd0323Model::height> Ssd0323Model::picture() const
{
    return on_ ? memory_ : decltype(memory_){};
}

void Ssd0323Model::take_command(std::uint8_t byte)
{
    if (pending_.empty()) {
        const auto found = std::ranges::find(commands, byte, &Command::code);
        if (found == commands.end())
            return fail("unknown command " + hex(byte));
        parameters_ = found->parameters;
    }
    pending_.push_back(byte);
    if (pending_.size() == 1 + parameters_) {
        execute();
        pending_.clear();
    }
}

void Ssd0323Model::execute()
{
    switch (pending_[0]) {
    case 0x15:
        return select(column_, memory_columns, "columns");
    case 0x75:
        return select(row_, memory_rows, "rows");
    case 0xA0:
        if (pending_[1] != 0x52)
            fail("orientation " + hex(pending_[1]) + " is not modelled");
        return;
    case 0xAE:
    case 0xAF:
        on_ = pending_[0] == 0xAF;
        return;
    default: // changes nothing that the picture is made of
        return;
    }
}

void Ssd0323Model::select(Axis& axis, int limit, const char* name)
{
    const int first = pending_[1];
    const int last = pending_[2];
    const std::string range = std::string{name} + ' ' + std::to_string(first) + " to " + std::to_string(last);
    if (first > last)
        return fail(range + ": reversed");
    if (last >= limit)
        return fail(range + ": the last one is " + std::to_string(limit - 1));
    axis = {.first = first, .last = last, .at = first, .given = true};
    window_full_ = false;
}

void Ssd0323Model::take_data(std::uint8_t byte)
{
    if (!pending_.empty())
        return fail("data where command " + hex(pending_[0]) + " lacks parameters");
    if (!on_)
        return fail("pixels before the display is on");
    if (!column_.given || !row_.given)
        return fail("pixels before a window is set");
    if (window_full_)
        return fail("more pixels than the window holds");

    if (row_.at < height) {
        const auto left = static_cast<std::size_t>(row_.at * width + 2 * column_.at);
        memory_[left] = byte >> 4;
        memory_[left + 1] = byte & 15;
    }
    if (++column_.at <= column_.last)
        return;
    column_.at = column_.first;
    window_full_ = ++row_.at > row_.last;
}

void Ssd0323Model::fail(const std::string& what)
{
    error_ = "byte " + std::to_string(position_) + ": " + what;
}

}
