#include "host/config/wiring.hpp"

#include "firmware/settings/board_rules.hpp"
#include "host/config/panel_labels.hpp"
#include "host/config/pico_pins.hpp"
#include "host/config/setting_words.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <array>

namespace kfast::config {

namespace {

constexpr int supply = rp2040::pico_supply_pin;
constexpr int display_ground = 38;

/// In their order on most modules.
constexpr std::array display_roles{PinRole::clock,  PinRole::data,      PinRole::reset,  PinRole::dc,
                                   PinRole::select, PinRole::backlight, PinRole::tearing};

constexpr std::array converter_roles{PinRole::select, PinRole::clock, PinRole::data, PinRole::ldac};

/// Gathers the wires of one part after another.
class Wiring {
public:
    explicit Wiring(const BoardSettings& settings) : settings_{settings} {}

    std::vector<Connection> connections() &&
    {
        if (leads_beam(settings_.bus))
            add_converter();
        else
            add_display();
        for (std::size_t i = 0; i < settings_.controls.size(); ++i)
            add_control(settings_.controls[i], i + 1);
        add_log();
        return std::move(list_);
    }

private:
    void add(std::string end, int pin, std::string purpose = {})
    {
        list_.push_back({.part = part_, .end = std::move(end), .pin = pin, .purpose = std::move(purpose)});
    }

    void add_optional(std::string end, int pin, std::string purpose)
    {
        add(std::move(end), pin, std::move(purpose));
        list_.back().is_optional = true;
    }

    void add_gpio(std::string end, Pin gpio, std::string purpose)
    {
        list_.push_back({.part = part_,
                         .end = std::move(end),
                         .pin = edge_pin(gpio),
                         .gpio = gpio,
                         .purpose = std::move(purpose)});
    }

    void add_display()
    {
        part_ = "display";
        add("GND", display_ground);
        add("VCC or 3V3", supply);
        for (const PinRole role : display_roles)
            add_role(role);
        if (settings_.bus == BusKind::parallel_8)
            add("RD", supply, "nothing is read");
    }

    /// Its supply is that of the Pico, so that levels of 3.3 V are high for it, and its references are the
    /// supply: the beam has all of 0 to 3.3 V.
    void add_converter()
    {
        part_ = converter_part;
        add("VSS (12)", display_ground);
        add("VDD (1)", supply);
        for (const PinRole role : converter_roles)
            add_role(role);
        add("SHDN (9)", supply, "never off");
        add("VREFB (11)", supply, "how far y goes");
        add("VREFA (13)", supply, "how far x goes");
        part_ = "display";
        add("GND", nearest_ground(edge_pin(settings_.pin(PinRole::blank))));
        add_role(PinRole::blank);
    }

    void add_role(PinRole role)
    {
        const PinRow row = pins_of(settings_, role);
        const std::string label{panel_label(role, settings_)};
        if (row.count > 1)
            return add_row(label, row);
        if (row.count == 1)
            return add_gpio(label.empty() ? word_of(role) : label, settings_.pin(role), function_of(role));
        add_idle(label, idle_level(role, settings_));
    }

    void add_row(const std::string& label, PinRow row)
    {
        for (int i = 0; i < row.count; ++i)
            add_gpio(label + std::to_string(i), static_cast<Pin>(row.first + i), {});
    }

    void add_idle(const std::string& label, IdleLevel level)
    {
        if (level == IdleLevel::low)
            add_optional(label, display_ground, "if there is such a pin: always selected");
        if (level == IdleLevel::high)
            add_optional(label, supply, "if there is such a pin: never off");
    }

    std::string function_of(PinRole role) const
    {
        if (role == PinRole::blank)
            return "dark when high";
        return std::string{rp2040::function_name(role, settings_.bus, settings_.pin(role))};
    }

    void add_button(const Control& control)
    {
        const int pin = edge_pin(control.pin);
        add_gpio("one leg", control.pin, purpose_of(control));
        add("other leg", nearest_ground(pin));
    }

    void add_knob(const Control& control)
    {
        const int pin = edge_pin(control.pin);
        add("left end", nearest_ground(pin));
        add_gpio("slider", control.pin, purpose_of(control));
        add("right end", supply);
    }

    void add_control(const Control& control, std::size_t number)
    {
        part_ = (control.kind == ControlKind::knob ? "knob " : "button ") + std::to_string(number);
        if (control.kind == ControlKind::button)
            add_button(control);
        if (control.kind == ControlKind::knob)
            add_knob(control);
    }

    static std::string purpose_of(const Control& control)
    {
        std::string purpose = word_of(control.action);
        if (has_name(control.action) && !control.name.view().empty())
            purpose += ' ' + visible(control.name.view());
        return purpose;
    }

    void add_log()
    {
        const Pin pin = settings_.pin(PinRole::log);
        if (pin == no_pin)
            return;
        part_ = "serial adapter";
        add_gpio("RXD", pin, function_of(PinRole::log) + ", 115200 baud");
        add("GND", nearest_ground(edge_pin(pin)));
    }

    const BoardSettings& settings_;
    std::string part_; ///< the part whose wires are being added
    std::vector<Connection> list_;
};

}

std::vector<Connection> wiring(const BoardSettings& settings) { return Wiring{settings}.connections(); }

namespace {

using Marks = std::array<std::string, edge_pins + 1>; ///< by the number of the pin

constexpr std::size_t left_name_width = std::string_view{"GP15"}.size();
constexpr std::size_t right_name_width = std::string_view{"ADC_VREF"}.size();
constexpr std::size_t number_width = 2;

/// The most likely of the names that the end may have; for parts other than the display, their own name.
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
