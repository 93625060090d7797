#include "host/config/pins_reader.hpp"

#include "firmware/settings/rp2040_pins.hpp"
#include "host/config/panel_labels.hpp"
#include "host/config/setting_words.hpp"
#include "host/schema/property_rule.hpp"
#include "host/schema/value_reader.hpp"
#include "host/text/characters.hpp"
#include "host/text/suggestion.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace kfast::config {

namespace {

using schema::Range, schema::Report;

constexpr Range numbers{0, rp2040::pin_count - 1};

bool report_unknown_role(const kdl::Node& node, const kdl::Property& property, Report& report)
{
    const std::optional<PinRole> printed = role_printed_as(property.name);
    if (!printed)
        return report_unknown_property(node, property, pin_role_names, report);
    const std::string role = word_of(*printed);
    return report.error(property.name_span, "pins has no property " + in_quotes(property.name),
                        "here it is called " + role + ": write " + role + "=…");
}

bool read_role(const kdl::Node& node, const kdl::Property& property, Draft& draft, Report& report)
{
    const auto name = std::ranges::find(pin_role_names, property.name);
    if (name == pin_role_names.end())
        return report_unknown_role(node, property, report);
    Pin& pin = draft.settings.pins[static_cast<std::size_t>(name - pin_role_names.begin())];
    return schema::assign(read_pin(property.value, report), pin);
}

}

std::optional<Pin> read_pin(const kdl::Value& value, schema::Report& report)
{
    if (value.number() == nullptr) {
        report.error(value.place, "the number of a GPIO is expected here", "write 18 for GP18");
        return std::nullopt;
    }
    Pin pin = no_pin;
    return schema::assign(read_whole_number(value, numbers, report), pin) ? std::optional{pin} : std::nullopt;
}

bool read_pins(const kdl::Node& node, Draft& draft, schema::Report& report)
{
    draft.pins = &node;
    bool good = true;
    for (const kdl::Property& property : node.properties)
        good = read_role(node, property, draft, report) && good;
    return good;
}

namespace {

using schema::Report;

/// Reads a name; `what` is named: a clip or an input.
bool read_stored_name(const kdl::Value& value, std::string_view what, StoredName& stored, Report& report)
{
    const auto name = read_name(value, report);
    if (!name)
        return false;
    if (name->size() > longest_stored_name)
        return report.error(value.place,
                            "a board holds names of " + std::string{what} + "s up to " +
                                std::to_string(longest_stored_name) + " bytes",
                            "give the " + std::string{what} + " a shorter name in the scene");
    stored = StoredName{*name};
    return true;
}

/// Reports what a control of this kind, or any, does not do.
void report_unknown_action(const kdl::Value& value, std::string_view name, ControlKind kind, Report& report)
{
    std::vector<std::string_view> known;
    for (std::size_t i = 0; i < control_action_names.size(); ++i)
        if (is_for(static_cast<ControlAction>(i), kind))
            known.push_back(control_action_names[i]);
    const bool is_of_others = std::ranges::find(control_action_names, name) != control_action_names.end();
    if (is_of_others)
        report.error(value.place,
                     std::string{name} + " is not for a " + (kind == ControlKind::knob ? "knob" : "button"),
                     suggestion({}, known));
    else
        report_unknown_word(value, name, known, report);
}

std::optional<ControlAction> read_action(const kdl::Value& value, ControlKind kind, Report& report)
{
    const auto name = read_text(value, report);
    if (!name)
        return std::nullopt;
    const auto place = std::ranges::find(control_action_names, *name);
    const auto action = static_cast<ControlAction>(place - control_action_names.begin());
    if (place != control_action_names.end() && is_for(action, kind))
        return action;
    report_unknown_action(value, *name, kind, report);
    return std::nullopt;
}

bool read_name_of(const kdl::Node& node, Control& control, Report& report)
{
    if (node.arguments.size() < 3)
        return true;
    if (has_name(control.action))
        return read_stored_name(node.arguments[2], has_input(control.action) ? "input" : "clip", control.name,
                                report);
    return report.error(node.arguments[2].place, *node.arguments[1].string() + " is for no clip or input",
                        "remove it");
}

bool has_capacity(const kdl::Node& node, const Draft& draft, Report& report)
{
    return draft.controls < BoardSettings::max_controls ||
           report.error(node.name_span,
                        "a board has at most " + std::to_string(BoardSettings::max_controls) +
                            " buttons and knobs",
                        "remove this one");
}

bool read_control(const kdl::Node& node, ControlKind kind, Draft& draft, Report& report)
{
    Control control{.kind = kind, .action = ControlAction::play, .pin = no_pin, .name = {}};
    const bool has_pin = schema::assign(read_pin(node.arguments[0], report), control.pin);
    const bool has_action = schema::assign(read_action(node.arguments[1], kind, report), control.action);
    if (!refuse_properties(node, report) || !has_capacity(node, draft, report) || !has_pin || !has_action ||
        !read_name_of(node, control, report))
        return false;
    draft.control_nodes[draft.controls] = &node;
    draft.settings.controls[draft.controls++] = control;
    return true;
}

}

bool read_clip(const kdl::Node& node, Draft& draft, schema::Report& report)
{
    return refuse_properties(node, report) &&
           read_stored_name(node.arguments.front(), "clip", draft.settings.clip, report);
}

bool read_button(const kdl::Node& node, Draft& draft, schema::Report& report)
{
    return read_control(node, ControlKind::button, draft, report);
}

bool read_knob(const kdl::Node& node, Draft& draft, schema::Report& report)
{
    return read_control(node, ControlKind::knob, draft, report);
}

}
