#include "host/simulator/ssd0323_model.hpp"

#include <array>

namespace kfast {
namespace {

using Axis = AddressWindow::Axis;

constexpr int columns = 128;
constexpr int bytes_of_row = columns / 2;
constexpr int rows = 80;
constexpr int brightest = 15;

// Bits of the remap.
constexpr std::uint8_t mirrors_bytes = 0x01;
constexpr std::uint8_t high_nibble_first = 0x02;
constexpr std::uint8_t scans_from_last = 0x10;
constexpr std::uint8_t splits_lines = 0x40; ///< as modules are wired
constexpr std::uint8_t known = mirrors_bytes | high_nibble_first | scans_from_last | splits_lines;

const std::vector<CommandForm> commands{
    {0x15, 2}, // columns, counted in bytes
    {0x75, 2}, // rows
    {0x81, 1}, // contrast
    {0x84, 0}, // a quarter of the current
    {0x85, 0}, // half of it
    {0x86, 0}, // all of it
    {0xA0, 1}, // remap
    {0xA1, 1}, // start line
    {0xA2, 1}, // display offset
    {0xA4, 0}, // the memory is shown
    {0xA5, 0}, // all pixels are lit
    {0xA6, 0}, // all pixels are dark
    {0xA7, 0}, // the memory is shown inverted
    {0xA8, 1}, // lines
    {0xAD, 1}, // supply
    {0xAE, 0}, // off
    {0xAF, 0}, // on
    {0xB1, 1}, // phases
    {0xB2, 1}, // row period
    {0xB3, 1}, // clock
    {0xB8, 8}, // grey table
    {0xBC, 1}, // precharge voltage
    {0xBE, 1}, // VCOMH
    {0xBF, 1}, // VSL
    {0xE3, 0}, // nothing
};

/// By A4h to A7h.
constexpr std::array choices{OledShow::memory, OledShow::all_lit, OledShow::all_dark, OledShow::inverse};
constexpr std::array needed{NeededCommand{0xA0}, NeededCommand{0xA8}};

/// Counted around the rows of the memory.
constexpr int around(int row) { return (row % rows + rows) % rows; }

}

Ssd0323Model::Ssd0323Model(const PanelSettings& settings)
    : OledModel{commands, ParameterLine::low, settings, {columns, rows}, needed}, memory_(columns * rows)
{
}

Frame Ssd0323Model::picture() const
{
    return painted_frame<PixelFormat::grey4>(settings_.glass,
                                             [this](int x, int y) { return level_at(x, y); });
}

std::uint32_t Ssd0323Model::level_at(int x, int y) const
{
    const auto row = row_of(settings_.row + y);
    if (!oled_.is_on || oled_.show == OledShow::all_dark || !row)
        return 0;
    if (oled_.show == OledShow::all_lit)
        return brightest;
    const int level = memory_[static_cast<std::size_t>(*row * columns + settings_.column + x)];
    return static_cast<std::uint32_t>(inverts() ? brightest - level : level);
}

void Ssd0323Model::execute(std::uint8_t code, Parameters parameters)
{
    switch (code) {
    case 0x15:
        return select(Axis::columns, parameters, bytes_of_row);
    case 0x75:
        return select(Axis::rows, parameters, rows);
    case 0x81:
    case 0xA0:
    case 0xA1:
    case 0xA2:
    case 0xA8:
        return execute_geometry(code, parameters[0]);
    default:
        return execute_display(code);
    }
}

void Ssd0323Model::execute_geometry(std::uint8_t code, std::uint8_t value)
{
    if (code == 0xA0)
        return set_remap(value);
    // A display offset of all rows is written as 80, too.
    const int limit = code == 0x81 ? 127 : code == 0xA2 ? rows : rows - 1;
    if (value > limit || (code == 0xA8 && value < 15))
        return fail(std::to_string(value) + " is no parameter of " + hex(code));
    if (code == 0xA1)
        oled_.start = value;
    else if (code == 0xA2)
        registers_.offset = value;
    else if (code == 0xA8)
        oled_.lines = value + 1;
}

void Ssd0323Model::execute_display(std::uint8_t code)
{
    switch (code) {
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
    default: // changes nothing that the picture is made of
        return;
    }
}

void Ssd0323Model::set_remap(std::uint8_t remap)
{
    registers_.remap = remap;
    if ((remap & ~known) != 0 || (remap & splits_lines) == 0)
        fail("orientation " + hex(remap) + " is not modelled");
}

void Ssd0323Model::take_pixels(std::uint8_t byte)
{
    if (!is_ready())
        return;
    AddressWindow& window = oled_.window; // its columns count bytes
    const bool is_mirrored = (registers_.remap & mirrors_bytes) != 0;
    const bool high_first = (registers_.remap & high_nibble_first) != 0;
    const int column = 2 * (is_mirrored ? bytes_of_row - 1 - window.column() : window.column());
    take_pixel(column, window.row(), high_first ? byte >> 4 : byte & 15);
    take_pixel(column + 1, window.row(), high_first ? byte & 15 : byte >> 4);
    window.advance(Axis::columns);
}

void Ssd0323Model::take_pixel(int column, int row, int level)
{
    const GlassPlace place{column, row, column - settings_.column, line_of(row) - settings_.row};
    if (const auto mistake = place.mistake(settings_.glass))
        return fail(*mistake);
    memory_[static_cast<std::size_t>(row * columns + column)] = static_cast<std::uint8_t>(level);
}

/// What a line of the glass shows; nothing if it is not scanned. The display offset shifts the rows on the
/// wires, which are mirrored after that.
std::optional<int> Ssd0323Model::row_of(int line) const
{
    const int place = mirrored(around(settings_.glass.height - 1 - line));
    const int step = around(place + registers_.offset);
    if (step >= oled_.lines)
        return std::nullopt;
    return around(oled_.start + step);
}

/// The line of the glass that shows a row, or one beyond it.
int Ssd0323Model::line_of(int row) const
{
    const int step = around(row - oled_.start);
    if (step >= oled_.lines)
        return rows;
    return around(settings_.glass.height - 1 - mirrored(around(step - registers_.offset)));
}

int Ssd0323Model::mirrored(int wire) const
{
    return (registers_.remap & scans_from_last) != 0 ? rows - 1 - wire : wire;
}

}
