#include "host/simulator/ssd1306_model.hpp"

#include <array>

namespace kfast {
namespace {

using Axis = AddressWindow::Axis;

constexpr int columns = 128;
constexpr int rows = 64;
constexpr int rows_of_page = 8;
constexpr int pages = rows / rows_of_page;

// How the lines are wired to the two sides of the glass.
constexpr std::uint8_t one_after_another = 0x02;
constexpr std::uint8_t in_turns = 0x12;

constexpr int not_modelled = CommandForm::not_modelled;

std::vector<CommandForm> commands()
{
    std::vector<CommandForm> forms{
        {0x20, 1},            // addressing
        {0x21, 2},            // columns
        {0x22, 2},            // pages
        {0x26, not_modelled}, // scrolling
        {0x27, not_modelled}, //
        {0x29, not_modelled}, //
        {0x2A, not_modelled}, //
        {0x2E, 0},            // no scrolling
        {0x2F, not_modelled}, // scrolling
        {0x81, 1},            // brightness
        {0x8D, 1},            // voltage pump
        {0xA0, 0},            // columns mirrored
        {0xA1, 0},            // and not
        {0xA3, not_modelled}, // area that scrolls
        {0xA4, 0},            // the memory is shown
        {0xA5, 0},            // all pixels are lit
        {0xA6, 0},            // not inverted
        {0xA7, 0},            // inverted
        {0xA8, 1},            // lines
        {0xAE, 0},            // off
        {0xAF, 0},            // on
        {0xC0, 0},            // scanned from the first line on
        {0xC8, 0},            // from the last one on
        {0xD3, 1},            // display offset
        {0xD5, 1},            // clock
        {0xD9, 1},            // phases
        {0xDA, 1},            // wiring of the lines
        {0xDB, 1},            // voltage
        {0xE3, 0},            // nothing
    };
    for (int low = 0; low < 64; ++low)
        forms.push_back({0x40 + low, 0}); // start line
    for (int low = 0; low < 32; ++low)
        forms.push_back({low, 0}); // column of the page addressing
    for (int page = 0; page < pages; ++page)
        forms.push_back({0xB0 + page, 0}); // page of the page addressing
    return forms;
}

constexpr std::array needed{
    NeededCommand{0x20}, NeededCommand{0x8D},       NeededCommand{0xA8},
    NeededCommand{0xDA}, NeededCommand{0xA0, 0xA1}, NeededCommand{0xC0, 0xC8},
};

bool sets_window(std::uint8_t code) { return code == 0x21 || code == 0x22; }

bool sets_page_place(std::uint8_t code) { return code < 0x20 || (code >= 0xB0 && code < 0xB0 + pages); }

}

Ssd1306Model::Ssd1306Model(const PanelSettings& settings)
    : OledModel{commands(), ParameterLine::low, settings, {columns, rows}, needed}, memory_(columns * rows)
{
}

Frame Ssd1306Model::picture() const
{
    const bool inverts = settings_.inverted != registers_.inverts;
    return painted_frame<PixelFormat::mono1>(settings_.glass, [&](int x, int y) -> std::uint32_t {
        const auto row = scan().row_of(settings_.row + y);
        if (!oled_.is_on || !row)
            return 0;
        const bool is_set = memory_[static_cast<std::size_t>(*row * columns + settings_.column + x)];
        return registers_.is_all_lit || is_set != inverts ? 1 : 0;
    });
}

void Ssd1306Model::begin(std::uint8_t code)
{
    const bool is_paged = registers_.addressing == Addressing::page;
    if (sets_window(code) && is_paged)
        fail("command " + hex(code) + " in page addressing");
    if (sets_page_place(code) && !is_paged)
        fail("command " + hex(code) + " in horizontal or vertical addressing");
    OledModel::begin(code);
    if (code == 0xAF && !registers_.has_pump)
        fail("the display is switched on before the voltage pump");
}

void Ssd1306Model::execute(std::uint8_t code, Parameters parameters)
{
    if (sets_window(code) || sets_page_place(code) || code == 0x20)
        return execute_place(code, parameters);
    execute_geometry(code, parameters);
    execute_display(code, parameters);
}

void Ssd1306Model::execute_place(std::uint8_t code, Parameters parameters)
{
    if (code == 0x20)
        return set_addressing(parameters[0]);
    if (sets_window(code)) {
        const bool is_columns = code == 0x21;
        return select(is_columns ? Axis::columns : Axis::rows, parameters, is_columns ? columns : pages);
    }
    if (code < 0x10)
        registers_.column = (registers_.column & 0xF0) | code;
    else if (code < 0x20)
        registers_.column = (registers_.column & 0x0F) | (code & 15) << 4;
    else
        registers_.page = code - 0xB0;
}

void Ssd1306Model::execute_geometry(std::uint8_t code, Parameters parameters)
{
    if (code >= 0x40 && code < 0x80)
        oled_.start = code - 0x40;
    switch (code) {
    case 0xA0:
    case 0xA1:
        registers_.mirrors_columns = code == 0xA0;
        return;
    case 0xA8:
        return set_lines(parameters[0]);
    case 0xC0:
    case 0xC8:
        registers_.scans_from_first = code == 0xC0;
        return;
    case 0xD3:
        return check_offset(parameters[0]);
    case 0xDA:
        return check_wiring(parameters[0]);
    default:
        return;
    }
}

void Ssd1306Model::execute_display(std::uint8_t code, Parameters parameters)
{
    switch (code) {
    case 0x8D:
        return set_pump(parameters[0]);
    case 0xA4:
    case 0xA5:
        registers_.is_all_lit = code == 0xA5;
        return;
    case 0xA6:
    case 0xA7:
        registers_.inverts = code == 0xA7;
        return;
    case 0xAE:
    case 0xAF:
        oled_.is_on = code == 0xAF;
        return;
    default: // changes nothing that the picture is made of
        return;
    }
}

void Ssd1306Model::set_addressing(std::uint8_t mode)
{
    if (mode > 2)
        return fail("there is no addressing " + hex(mode));
    registers_.addressing = static_cast<Addressing>(mode);
    oled_.window = {};
}

void Ssd1306Model::check_wiring(std::uint8_t wiring)
{
    if (wiring != in_turns && wiring != one_after_another)
        return fail("lines wired like " + hex(wiring) + " are not modelled");
    if ((settings_.glass == Size{128, 64} && wiring != in_turns) ||
        (settings_.glass == Size{128, 32} && wiring != one_after_another))
        fail("the lines of this glass are not wired like " + hex(wiring));
}

void Ssd1306Model::set_pump(std::uint8_t pump)
{
    if ((pump & 0x3B) != 0x10)
        return fail("the voltage pump has no setting " + hex(pump));
    const bool has_pump = (pump & 4) != 0;
    if (oled_.is_on && has_pump != registers_.has_pump)
        return fail("the voltage pump is switched while the display is on");
    registers_.has_pump = has_pump;
}

void Ssd1306Model::take_pixels(std::uint8_t byte)
{
    const AddressWindow& window = oled_.window;
    const bool is_paged = registers_.addressing == Addressing::page;
    if (!is_ready(is_paged || window.is_given(), is_paged ? registers_.column >= columns : window.is_full()))
        return;
    take_byte(is_paged ? registers_.column : window.column(), is_paged ? registers_.page : window.row(),
              byte);
    advance();
}

void Ssd1306Model::take_byte(int column, int page, std::uint8_t byte)
{
    const int segment = registers_.mirrors_columns ? columns - 1 - column : column;
    for (int bit = 0; bit < rows_of_page; ++bit) {
        const int row = rows_of_page * page + bit;
        const GlassPlace place{segment, row, segment - settings_.column, scan().line_of(row) - settings_.row};
        if (const auto mistake = place.mistake(settings_.glass))
            return fail(*mistake);
        memory_[static_cast<std::size_t>(row * columns + segment)] = (byte >> bit & 1) != 0;
    }
}

void Ssd1306Model::advance()
{
    if (registers_.addressing == Addressing::page)
        ++registers_.column;
    else
        oled_.window.advance(registers_.addressing == Addressing::vertical ? Axis::rows : Axis::columns);
}

OledScan Ssd1306Model::scan() const { return scan_of(registers_.scans_from_first); }

}
