#include "host/simulator/oled_model.hpp"

namespace kfast {

OledModel::OledModel(std::vector<CommandForm> forms, ParameterLine line, const PanelSettings& settings,
                     Size memory, std::span<const NeededCommand> required)
    : CommandModel{std::move(forms), line},
      settings_{settings},
      oled_{.lines = memory.height},
      memory_size_{memory},
      needed_{required}
{
}

void OledModel::begin(std::uint8_t code)
{
    if (code == 0xAE && oled_.window.is_begun() && !oled_.window.is_full())
        fail("sleep while the window waits for pixels");
}

void OledModel::select(AddressWindow::Axis axis, Parameters parameters, int limit)
{
    if (const auto mistake = oled_.window.set(axis, parameters[0], parameters[1], limit))
        fail(*mistake);
}

void OledModel::set_lines(int last)
{
    oled_.lines = last + 1;
    if (last < 15 || last >= memory_size_.height)
        fail("the last line is " + std::to_string(last) + ": it lies between 15 and " +
             std::to_string(memory_size_.height - 1));
}

void OledModel::check_offset(int offset)
{
    if (offset != 0)
        fail("a display offset of " + std::to_string(offset) + " is not modelled");
}

bool OledModel::is_ready(bool has_window, bool is_full)
{
    if (const auto code = missing(needed_))
        fail("pixels before " + hex(*code) + " was given");
    else if (!has_window)
        fail("pixels before a window is set");
    else if (is_full)
        fail("more pixels than the window holds");
    else
        return true;
    return false;
}

OledScan OledModel::scan_of(bool from_last) const
{
    return {.memory_rows = memory_size_.height,
            .lines = oled_.lines,
            .start = oled_.start,
            .from_last = from_last};
}

}
