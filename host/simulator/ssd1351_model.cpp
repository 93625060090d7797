#include "host/simulator/ssd1351_model.hpp"

#include <algorithm>
#include <array>

namespace kfast {
namespace {

using Axis = AddressWindow::Axis;

constexpr int side = 128;

// Bits of the remap.
constexpr std::uint8_t rows_first = 0x01;
constexpr std::uint8_t mirrors_columns = 0x02;
constexpr std::uint8_t red_first = 0x04;
constexpr std::uint8_t reserved = 0x08;
constexpr std::uint8_t scans_from_last = 0x10; ///< as modules are mounted: their upper line is the last one
constexpr std::uint8_t splits_lines = 0x20;    ///< as modules are wired

constexpr int not_modelled = CommandForm::not_modelled;

const std::vector<CommandForm> commands{
    {0x15, 2},            // columns
    {0x5C, 0},            // write
    {0x5D, not_modelled}, // read
    {0x75, 2},            // rows
    {0x96, not_modelled}, // scrolling
    {0x9E, 0},            // no scrolling
    {0x9F, not_modelled}, // scrolling
    {0xA0, 1},            // remap
    {0xA1, 1},            // start line
    {0xA2, 1},            // display offset
    {0xA4, 0},            // all pixels are dark
    {0xA5, 0},            // all pixels are lit
    {0xA6, 0},            // the memory is shown
    {0xA7, 0},            // it is shown inverted
    {0xAB, 1},            // voltage of the logic
    {0xAD, 0},            // nothing
    {0xAE, 0},            // off
    {0xAF, 0},            // on
    {0xB0, 0},            // nothing
    {0xB1, 1},            // phases
    {0xB2, 3},            // enhancement
    {0xB3, 1},            // clock
    {0xB4, 3},            // voltage of the segments
    {0xB5, 1},            // pins
    {0xB6, 1},            // second precharge
    {0xB8, 63},           // grey table
    {0xB9, 0},            // evenly spaced
    {0xBB, 1},            // precharge voltage
    {0xBE, 1},            // VCOMH
    {0xC1, 3},            // contrast
    {0xC7, 1},            // master current
    {0xCA, 1},            // lines
    {0xD1, 0},            // nothing
    {0xE3, 0},            // nothing
    {0xFD, 1},            // lock
};

constexpr std::array<std::uint8_t, 6> inner_commands{0xA2, 0xB1, 0xB3, 0xBB, 0xBE, 0xC1};
/// By A4h to A7h.
constexpr std::array choices{OledShow::all_dark, OledShow::all_lit, OledShow::memory, OledShow::inverse};
constexpr std::array needed{NeededCommand{0xA0}, NeededCommand{0xA2}, NeededCommand{0xCA}};

StoredColour colour_of(std::uint32_t bits, int count)
{
    if (count == 16)
        return from_rgb565(bits);
    const auto channel = [bits](int shift) { return static_cast<std::uint8_t>(bits >> shift & 63); };
    return {channel(16), channel(8), channel(0)};
}

}

Ssd1351Model::Ssd1351Model(const PanelSettings& settings)
    : OledModel{commands, ParameterLine::high, settings, {side, side}, needed}, memory_{{side, side}}
{
}

Frame Ssd1351Model::picture() const
{
    const bool is_dark = !oled_.is_on || oled_.show == OledShow::all_dark;
    const ColourPath path{.swaps = settings_.bgr == ((registers_.remap & red_first) != 0),
                          .inverts = inverts()};
    return painted_frame<PixelFormat::rgb565>(settings_.glass, [&](int x, int y) -> std::uint32_t {
        const auto row = scan().row_of(settings_.row + y);
        if (is_dark || !row)
            return 0;
        return oled_.show == OledShow::all_lit ? 0xFFFF : path.rgb565(memory_.at(settings_.column + x, *row));
    });
}

void Ssd1351Model::begin(std::uint8_t code)
{
    if (registers_.is_locked && code != 0xFD)
        fail("command " + hex(code) + " while the commands are locked");
    if (!registers_.is_inner_open && std::ranges::find(inner_commands, code) != inner_commands.end())
        fail("command " + hex(code) + " before 0xFD with 0xB1 has opened it");
    if (registers_.bit_count != 0)
        fail("command " + hex(code) + " in the middle of a pixel");
    OledModel::begin(code);
}

void Ssd1351Model::execute(std::uint8_t code, Parameters parameters)
{
    switch (code) {
    case 0x15:
        registers_.has_new_columns = true;
        return select(Axis::columns, parameters, side);
    case 0x75:
        registers_.has_new_rows = true;
        return select(Axis::rows, parameters, side);
    case 0x5C:
        return start_writing();
    case 0xFD:
        return set_lock(parameters[0]);
    default:
        return execute_display(code, parameters);
    }
}

void Ssd1351Model::execute_display(std::uint8_t code, Parameters parameters)
{
    switch (code) {
    case 0xA0:
        return set_remap(parameters[0]);
    case 0xA1:
        oled_.start = parameters[0];
        if (oled_.start >= side)
            fail("the start line is " + std::to_string(oled_.start) + ": the last one is 127");
        return;
    case 0xA2:
        return check_offset(parameters[0]);
    case 0xA4:
    case 0xA5:
    case 0xA6:
    case 0xA7:
        oled_.show = choices[code - 0xA4];
        return;
    case 0xAE:
    case 0xAF:
        oled_.is_on = code == 0xAF;
        return;
    case 0xC7:
        if (parameters[0] > 15)
            fail("the master current is " + std::to_string(parameters[0]) + ": the largest is 15");
        return;
    case 0xCA:
        return set_lines(parameters[0]);
    default: // changes nothing that the picture is made of
        return;
    }
}

void Ssd1351Model::start_writing()
{
    if (!registers_.has_new_columns || !registers_.has_new_rows)
        fail("0x5C without new columns and rows");
    registers_.has_new_columns = false;
    registers_.has_new_rows = false;
}

void Ssd1351Model::set_remap(std::uint8_t remap)
{
    registers_.remap = remap;
    if ((remap & reserved) != 0 || (remap & splits_lines) == 0 || pixel_bits() == 0)
        fail("remap " + hex(remap) + " is not modelled");
}

void Ssd1351Model::set_lock(std::uint8_t key)
{
    switch (key) {
    case 0x12:
    case 0x16:
        registers_.is_locked = key == 0x16;
        return;
    case 0xB0:
    case 0xB1:
        registers_.is_inner_open = key == 0xB1;
        return;
    default:
        return fail("the lock has no key " + hex(key));
    }
}

void Ssd1351Model::take_pixels(std::uint8_t byte)
{
    if (!is_ready())
        return;
    registers_.bits = registers_.bits << 8 | byte;
    registers_.bit_count += 8;
    if (registers_.bit_count < pixel_bits())
        return;
    registers_.bit_count = 0;
    take_pixel(colour_of(registers_.bits, pixel_bits()));
}

void Ssd1351Model::take_pixel(StoredColour colour)
{
    AddressWindow& window = oled_.window;
    const bool is_mirrored = (registers_.remap & mirrors_columns) != 0;
    const int column = is_mirrored ? side - 1 - window.column() : window.column();
    const GlassPlace place{column, window.row(), column - settings_.column,
                           scan().line_of(window.row()) - settings_.row};
    if (const auto mistake = place.mistake(settings_.glass))
        return fail(*mistake);
    memory_.at(column, window.row()) = colour;
    window.advance((registers_.remap & rows_first) != 0 ? Axis::rows : Axis::columns);
}

int Ssd1351Model::pixel_bits() const
{
    const int depth = registers_.remap >> 6;
    return depth == 1 ? 16 : depth == 2 ? 24 : 0;
}

OledScan Ssd1351Model::scan() const { return scan_of((registers_.remap & scans_from_last) == 0); }

}
