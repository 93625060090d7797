#include "host/simulator/dcs_model.hpp"

#include "firmware/settings/controller_facts.hpp"
#include "host/simulator/glass.hpp"

#include <array>
#include <utility>

namespace kfast {
namespace {

using std::chrono::milliseconds;
using Axis = AddressWindow::Axis;

constexpr milliseconds sleep_change{120}; ///< from sleep out to sleep in, and back; from reset to sleep out
constexpr milliseconds after_sleep_in{5};

constexpr std::uint8_t mirrors_rows = 0x80;
constexpr std::uint8_t mirrors_columns = 0x40;
constexpr std::uint8_t exchanges = 0x20;
constexpr std::uint8_t blue_first = 0x08;

constexpr std::array needed{NeededCommand{0x36}, NeededCommand{0x3A}};

int u16(std::uint8_t high, std::uint8_t low) { return high << 8 | low; }

StoredColour colour_of(std::uint32_t bits, int count)
{
    if (count == 12)
        return from_rgb444(bits);
    if (count == 16)
        return from_rgb565(bits);
    const auto channel = [bits](int shift) { return static_cast<std::uint8_t>(bits >> shift & 63); };
    return {channel(18), channel(10), channel(2)};
}

}

DcsModel::DcsModel(const PanelSettings& settings, const DcsKind& kind)
    : CommandModel{kind.commands, ParameterLine::high},
      settings_{settings},
      kind_{kind},
      memory_size_{facts_of(settings.controller).memory},
      memory_{memory_size_},
      earliest_{kind_.reset_time, Time{}, sleep_change}
{
}

Frame DcsModel::picture() const
{
    const bool is_dark = !registers_.is_awake || !registers_.is_on;
    const ColourPath path{.swaps = settings_.bgr != ((registers_.access & blue_first) != 0),
                          .inverts = settings_.inverted != registers_.inverts};
    return painted_frame<PixelFormat::rgb565>(settings_.glass, [&](int x, int y) {
        const int column = settings_.column + x;
        const bool is_mirrored = kind_.is_wired_backwards && !registers_.starts_at_last_column;
        return is_dark ? 0
                       : path.rgb565(memory_.at(is_mirrored ? memory_size_.width - 1 - column : column,
                                                settings_.row + y));
    });
}

void DcsModel::forget()
{
    registers_ = {};
    earliest_ = {now() + kind_.reset_time, now(), now() + sleep_change};
}

void DcsModel::begin(std::uint8_t code)
{
    check_time(code);
    if (registers_.bit_count != 0)
        fail("command " + hex(code) + " in the middle of a pixel");
    if (code == 0x10 && registers_.is_writing)
        fail("sleep while the window waits for pixels");
}

void DcsModel::check_time(std::uint8_t code)
{
    if (now() < earliest_.command)
        fail("command " + hex(code) + " too soon after reset or sleep");
    if (code == 0x11 && now() < earliest_.sleep_out)
        fail("sleep out too soon: 120 ms pass after reset or sleep in");
    if ((code == 0x10 || code == 0x01) && now() < earliest_.sleep_in)
        fail(hex(code) + " too soon: 120 ms pass after sleep out");
}

void DcsModel::execute(std::uint8_t code, Parameters parameters)
{
    check_fixed_bits(code, parameters);
    switch (code) {
    case 0x20:
    case 0x21:
        registers_.inverts = code == 0x21;
        return;
    case 0x2A:
        return select(Axis::columns, parameters);
    case 0x2B:
        return select(Axis::rows, parameters);
    case 0x2C:
        registers_.window.restart();
        registers_.is_writing = true;
        return;
    case 0x36:
        return set_access(parameters[0]);
    case 0x3A:
        return set_format(parameters[0]);
    case 0x3C:
        return go_on_writing();
    case 0xB6:
        registers_.starts_at_last_column = kind_.is_wired_backwards && (parameters[1] & 0x20) != 0;
        return;
    default:
        return execute_power(code);
    }
}

void DcsModel::execute_power(std::uint8_t code)
{
    switch (code) {
    case 0x01:
        forget_commands();
        return forget();
    case 0x10:
        return fall_asleep();
    case 0x11:
        return wake();
    case 0x28:
    case 0x29:
        registers_.is_on = code == 0x29;
        return;
    default: // changes nothing that the picture is made of
        return;
    }
}

void DcsModel::check_fixed_bits(std::uint8_t code, Parameters parameters)
{
    for (const FixedBits& bits : kind_.fixed_bits)
        if (bits.code == code && (parameters[bits.parameter] & bits.mask) != bits.value)
            fail("parameter " + std::to_string(bits.parameter + 1) + " of " + hex(code) + " is " +
                 hex(parameters[bits.parameter]) + ", which is not modelled");
}

void DcsModel::wake()
{
    if (std::exchange(registers_.is_awake, true))
        return;
    earliest_.command = now() + kind_.wake_time;
    earliest_.sleep_in = now() + sleep_change;
}

void DcsModel::fall_asleep()
{
    if (!std::exchange(registers_.is_awake, false))
        return;
    earliest_.command = now() + after_sleep_in;
    earliest_.sleep_out = now() + sleep_change;
}

void DcsModel::set_access(std::uint8_t access)
{
    registers_.access = access;
    registers_.window = {};
    registers_.is_writing = false;
}

void DcsModel::set_format(std::uint8_t format)
{
    const int lower = format & (kind_.has_rgb_interface ? 15 : 7);
    const int upper = kind_.has_rgb_interface ? format >> 4 : 0;
    const bool is_upper_known = upper == 0 || upper == 5 || upper == 6;
    registers_.pixel_bits = lower == 3 && kind_.takes_12_bits ? 12 : lower == 5 ? 16 : lower == 6 ? 24 : 0;
    if (registers_.pixel_bits == 0 || !is_upper_known)
        fail("the controller has no pixel format " + hex(format));
}

void DcsModel::select(Axis axis, Parameters parameters)
{
    const int limit = axis == Axis::columns ? addressed().width : addressed().height;
    registers_.is_writing = false;
    if (const auto mistake = registers_.window.set(axis, u16(parameters[0], parameters[1]),
                                                   u16(parameters[2], parameters[3]), limit))
        fail(*mistake);
}

void DcsModel::go_on_writing()
{
    if (!registers_.is_writing)
        fail("0x3C where no pixels are missing");
}

void DcsModel::take_pixels(std::uint8_t byte)
{
    if (!is_ready())
        return;
    registers_.bits = registers_.bits << 8 | byte;
    registers_.bit_count += 8;
    if (registers_.bit_count < registers_.pixel_bits)
        return;
    registers_.bit_count -= registers_.pixel_bits;
    take_pixel(colour_of(registers_.bits >> registers_.bit_count, registers_.pixel_bits));
}

bool DcsModel::is_ready()
{
    if (!registers_.is_awake)
        fail("pixels before sleep out");
    else if (const auto code = missing(needed))
        fail("pixels before " + hex(*code) + " was given");
    else if (!registers_.window.is_given())
        fail("pixels before a window is set");
    else if (registers_.window.is_full())
        fail("more pixels than the window holds");
    else
        return true;
    return false;
}

void DcsModel::take_pixel(StoredColour colour)
{
    AddressWindow& window = registers_.window;
    int column = is_exchanged() ? window.row() : window.column();
    int row = is_exchanged() ? window.column() : window.row();
    if ((registers_.access & mirrors_columns) != 0)
        column = memory_size_.width - 1 - column;
    if ((registers_.access & mirrors_rows) != 0)
        row = memory_size_.height - 1 - row;

    const GlassPlace place{column, row, column - settings_.column, row - settings_.row};
    if (const auto mistake = place.mistake(settings_.glass))
        return fail(*mistake);
    memory_.at(column, row) = colour;
    window.advance(Axis::columns);
    registers_.is_writing = !window.is_full();
}

bool DcsModel::is_exchanged() const { return (registers_.access & exchanges) != 0; }

Size DcsModel::addressed() const
{
    return is_exchanged() ? Size{memory_size_.height, memory_size_.width} : memory_size_;
}

}
