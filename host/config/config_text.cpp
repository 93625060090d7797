#include "host/config/config_text.hpp"

#include "host/beam/beam_text.hpp"
#include "host/config/display_reader.hpp"
#include "host/config/mistake_text.hpp"
#include "host/config/pins_reader.hpp"
#include "host/config/setting_words.hpp"
#include "host/fit/other_hardware.hpp"
#include "host/kdl/canonical.hpp"
#include "host/kdl/parser.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/schema/value_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

namespace kfast::config {

namespace {

using schema::NodeForm, schema::PartRule, schema::Report, schema::Times, schema::Word;

constexpr std::array part_rules{
    PartRule<Draft>{
        {"panel", "panel st7789, or panel st7789 240 320", 1, 3}, read_panel, Times::at_most_once},
    PartRule<Draft>{beam_form, read_beam_part, Times::at_most_once},
    PartRule<Draft>{{"bus", "bus spi, bus i2c, bus parallel or bus dac", 1, 1}, read_bus},
    PartRule<Draft>{{"pins", "pins clock=18 data=19 select=17 dc=16 reset=20"}, read_pins},
    PartRule<Draft>{{"clip", "clip NAME", 1, 1}, read_clip, Times::at_most_once},
    PartRule<Draft>{{"button", "button 12 play, button 12 play CLIP or button 12 input NAME", 2, 3},
                    read_button,
                    Times::any},
    PartRule<Draft>{
        {"knob", "knob 26 place, knob 26 place CLIP or knob 26 input NAME", 2, 3}, read_knob, Times::any},
};

constexpr NodeForm board_form{"board", "board pico { panel …; bus …; pins … }", 1, 1, true};

/// Which pins there are, and what they can do.
constexpr std::array chips{Word<bool>{"pico", true}};

/// Fills in what may be left out, and follows from the rest.
void complete(Draft& draft)
{
    BoardSettings& settings = draft.settings;
    const std::uint32_t max = clock_range(settings.bus).max;
    const std::uint32_t rated = rated_clock(settings);
    settings.bus_clock = draft.clock.value_or(rated == 0 ? max : std::min(rated, max));
    if (!leads_beam(settings.bus))
        settings.panel.tearing_effect = draft.tearing.value_or(settings.pin(PinRole::tearing) != no_pin);
}

SourceSpan pin_place(PinUser user, const Draft& draft)
{
    if (user.is_control())
        return draft.control_nodes[user.control()]->arguments.front().place;
    return schema::property_span(*draft.pins, pin_role_names[static_cast<std::size_t>(user.role())]);
}

SourceSpan action_place(PinUser user, const Draft& draft)
{
    return draft.control_nodes[user.control()]->arguments[1].place;
}

SourceSpan glass_place(const kdl::Node& panel)
{
    const kdl::Value& value = panel.arguments.front();
    return panel.arguments.size() == 1 ? value.place
                                       : schema::span(panel.arguments[1].place, panel.arguments.back().place);
}

SourceSpan place_of(const SettingsMistake& mistake, const Draft& draft)
{
    switch (mistake.fault) {
    case SettingsFault::bus_not_taken:
        return draft.bus->arguments.front().place;
    case SettingsFault::glass_beyond_memory:
    case SettingsFault::glass_ragged:
        return glass_place(*draft.panel);
    case SettingsFault::rotation_not_done:
        return schema::property_span(*draft.panel, "rotation");
    case SettingsFault::clock_too_fast:
    case SettingsFault::clock_too_slow:
        return schema::property_span(*draft.bus, "clock");
    case SettingsFault::address_reserved:
        return schema::property_span(*draft.bus, "address");
    case SettingsFault::pin_missing:
    case SettingsFault::pin_not_on_board:
    case SettingsFault::pin_shared:
    case SettingsFault::function_missing:
    case SettingsFault::units_differ:
    case SettingsFault::converter_missing:
        return pin_place(*mistake.user, draft);
    case SettingsFault::action_not_of_control:
    case SettingsFault::input_missing:
    case SettingsFault::nothing_to_arm:
        return action_place(*mistake.user, draft);
    case SettingsFault::beam_beyond_limits:
        return draft.beam->name_span;
    case SettingsFault::beam_too_fast:
        return schema::property_span(*draft.beam, "rate");
    }
    return {};
}

void check_rules(const Draft& draft, Report& report)
{
    const std::vector<SettingsMistake> found = mistakes(draft.settings);
    for (const SettingsMistake& mistake : found) {
        const Finding finding = text_of(mistake, draft.settings);
        report.error(place_of(mistake, draft), finding.message, finding.hint);
    }
    if (const auto finding = clock_warning(draft.settings); finding && found.empty())
        report.warning(schema::property_span(*draft.bus, "clock"), finding->message, finding->hint);
}

void read_chip(const kdl::Value& name, Report& report)
{
    if (const auto other = name.string() == nullptr ? std::nullopt : fit::other_board_text(*name.string()))
        report.error(name.place, *other, "settings are for board pico");
    else
        read_word(name, chips, report);
}

void read_board(const kdl::Node& node, Draft& draft, Report& report)
{
    if (!fits(node, board_form, report) || !refuse_properties(node, report))
        return;
    read_chip(node.arguments.front(), report);
    read_parts(node, part_rules, draft, report);
    check_display(node, draft, report);
}

}

std::optional<BoardSettings> read_config(const SourceText& source, Diagnostics& diagnostics)
{
    const kdl::Document document = kdl::parse(source.text, diagnostics);
    if (diagnostics.has_errors())
        return std::nullopt;
    Report report{source, diagnostics};
    Draft draft;
    if (const kdl::Node* const node = only_node(document, board_form, "a text of settings", report))
        read_board(*node, draft, report);
    if (!diagnostics.has_errors()) {
        complete(draft);
        check_rules(draft, report);
    }
    return diagnostics.has_errors() ? std::nullopt : std::optional{draft.settings};
}

namespace {

using schema::frequency, schema::quantity_text;

constexpr std::string_view line = "\n    ";
constexpr std::string_view note = "\n    // ";

std::string flag_text(bool flag) { return flag ? "#true" : "#false"; }

/// The shortest fraction that represents it: three decimals distinguish all 256.
std::string brightness_text(std::uint8_t brightness)
{
    constexpr double full = 255;
    return schema::shortest_text(brightness / full,
                                 [=](double share) { return std::lround(share * full) == brightness; });
}

std::string panel_text(const BoardSettings& settings)
{
    const PanelSettings& panel = settings.panel;
    std::string text{note};
    text += "The glass, not turned; the picture on it is " + size_text(panel.size());
    text += line;
    text += "panel " + word_of(panel.controller) + ' ' + std::to_string(panel.glass.width) + ' ' +
            std::to_string(panel.glass.height) + " column=" + std::to_string(panel.column) +
            " row=" + std::to_string(panel.row) +
            " rotation=" + std::to_string(90 * static_cast<int>(panel.rotation)) +
            " colours=" + (panel.bgr ? "bgr" : "rgb") + " inverted=" + flag_text(panel.inverted) +
            " brightness=" + brightness_text(panel.brightness);
    if (panel.tearing_effect != (settings.pin(PinRole::tearing) != no_pin))
        text += " tearing=" + flag_text(panel.tearing_effect);
    return text;
}

std::string address_text(std::uint8_t address)
{
    std::array<char, 16> text{};
    std::snprintf(text.data(), text.size(), " address=0x%02X", unsigned{address});
    return text.data();
}

std::string shown_text(const BoardSettings& settings)
{
    if (leads_beam(settings.bus))
        return std::string{note} + "How the beam is led (docs/beam.md)" + std::string{line} +
               beam_text(settings.beam, line.substr(1));
    return panel_text(settings);
}

std::string bus_text(const BoardSettings& settings)
{
    std::string text{note};
    text += "The maker of " + (leads_beam(settings.bus) ? "MCP4922" : word_of(settings.panel.controller)) +
            " allows " + quantity_text(rated_clock(settings), frequency);
    if (clock_warning(settings))
        text += "; many bear more";
    text += line;
    text += "bus " + word_of(settings.bus) + " clock=" + quantity_text(settings.bus_clock, frequency);
    if (settings.bus == BusKind::i2c || settings.i2c_address != BoardSettings{}.i2c_address)
        text += address_text(settings.i2c_address);
    return text;
}

std::string pins_text(const BoardSettings& settings)
{
    std::string text{note};
    text += "Numbers of GPIOs; kfast wiring tells where they are\n    pins";
    for (std::size_t i = 0; i < settings.pins.size(); ++i)
        if (settings.pins[i] != no_pin)
            text += ' ' + std::string{pin_role_names[i]} + '=' + std::to_string(settings.pins[i]);
    return text;
}

std::string control_text(const Control& control)
{
    std::string text{line};
    text += (control.kind == ControlKind::knob ? "knob " : "button ") + std::to_string(control.pin) + ' ' +
            word_of(control.action);
    if (has_name(control.action) && !control.name.view().empty())
        text += ' ' + kdl::string_form(control.name.view());
    return text;
}

std::string clip_text(const StoredName& clip)
{
    if (clip.view().empty())
        return {};
    return std::string{note} + "What plays when nothing is touched" + std::string{line} + "clip " +
           kdl::string_form(clip.view());
}

}

std::string config_text(const BoardSettings& settings)
{
    std::string text = "board pico {" + shown_text(settings) + bus_text(settings) + pins_text(settings) +
                       clip_text(settings.clip);
    for (const Control& control : settings.controls)
        if (control.kind != ControlKind::none)
            text += control_text(control);
    return text + "\n}\n";
}

}
