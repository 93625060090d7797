#include "host/config/config_reader.hpp"

#include "host/beam/beam_reader.hpp"
#include "host/config/beam_part.hpp"
#include "host/config/bus_reader.hpp"
#include "host/config/control_reader.hpp"
#include "host/config/mistake_text.hpp"
#include "host/config/panel_reader.hpp"
#include "host/config/pins_reader.hpp"
#include "host/fit/other_hardware.hpp"
#include "host/kdl/parser.hpp"
#include "host/schema/part_rule.hpp"
#include "host/schema/property_rule.hpp"
#include "host/schema/value_reader.hpp"

#include <algorithm>
#include <array>
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

/// What may be left out, and follows from the rest.
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

}
