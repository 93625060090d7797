#include "host/config/pico_drawing.hpp"

#include "host/config/pico_edge.hpp"

#include <algorithm>
#include <array>

namespace kfast::config {
namespace {

using Marks = std::array<std::string, edge_pins + 1>; ///< by the number of the pin

constexpr std::size_t left_name_width = std::string_view{"GP15"}.size();
constexpr std::size_t right_name_width = std::string_view{"ADC_VREF"}.size();
constexpr std::size_t number_width = 2;

/// The likeliest of the names that the end may have; other parts than the display by their own name.
std::string mark_of(const Connection& wire)
{
    return wire.part == "display" || wire.part == converter_part
               ? wire.end.substr(0, wire.end.find_first_of(", "))
               : wire.part;
}

Marks marks_of(std::span<const Connection> wires)
{
    Marks marks;
    for (const Connection& wire : wires) {
        if (wire.is_optional)
            continue;
        std::string& mark = marks[static_cast<std::size_t>(wire.pin)];
        mark += (mark.empty() ? "" : ", ") + mark_of(wire);
    }
    return marks;
}

std::string to_left(const std::string& text, std::size_t width)
{
    return text + std::string(width - std::min(width, text.size()), ' ');
}

std::string to_right(const std::string& text, std::size_t width)
{
    return std::string(width - std::min(width, text.size()), ' ') + text;
}

std::size_t widest_left(const Marks& marks)
{
    std::size_t widest = 0;
    for (int pin = 1; pin <= pins_of_side; ++pin)
        widest = std::max(widest, marks[static_cast<std::size_t>(pin)].size());
    return widest;
}

std::string without_spaces_behind(std::string text)
{
    return text.erase(text.find_last_not_of(' ') + 1) + '\n';
}

std::string row(int left, const Marks& marks, std::size_t width)
{
    const int right = edge_pins + 1 - left;
    return without_spaces_behind(
        to_right(marks[static_cast<std::size_t>(left)], width) + "  " +
        to_right(edge_name(left), left_name_width) + ' ' + to_right(std::to_string(left), number_width) +
        " |o       o| " + to_left(std::to_string(right), number_width) + ' ' +
        to_left(edge_name(right), right_name_width) + "  " + marks[static_cast<std::size_t>(right)]);
}

}

std::string pico_drawing(std::span<const Connection> wires)
{
    const Marks marks = marks_of(wires);
    const std::size_t width = widest_left(marks);
    const std::string margin(width + 2 + left_name_width + 1 + number_width + 1, ' ');
    std::string text = margin + "+--|USB|--+\n";
    for (int pin = 1; pin <= pins_of_side; ++pin)
        text += row(pin, marks, width);
    return text + margin + "+---------+\n";
}

}
