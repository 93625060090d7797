#include "host/config/panel_reader.hpp"

#include "core/player.hpp"
#include "firmware/settings/controller_facts.hpp"
#include "host/config/named_words.hpp"
#include "host/fit/other_hardware.hpp"
#include "host/schema/property_rule.hpp"
#include "host/schema/value_reader.hpp"
#include "host/text/glyph.hpp"

#include <array>
#include <cmath>

namespace kfast::config {
namespace {

using schema::assign, schema::PropertyRule, schema::Range, schema::Report, schema::Word;

constexpr Range sides{1, Player::max_panel};
constexpr Range places{0, Player::max_panel};
constexpr Range degrees{0, 360};
constexpr Range shares{0, 1};
constexpr int quarter = 90;
constexpr double full_brightness = 255;

constexpr std::array controller_words = named_words<Controller>(controller_names);
constexpr std::array colour_words{Word<bool>{"rgb", false}, Word<bool>{"bgr", true}};

bool read_rotation(const kdl::Value& value, Draft& draft, Report& report)
{
    const auto angle = read_whole_number(value, degrees, report);
    if (!angle)
        return false;
    if (*angle % quarter != 0 || *angle == 4 * quarter)
        return report.error(value.place, "a picture is turned by quarters, clockwise",
                            "write 0, 90, 180 or 270");
    draft.settings.panel.rotation = static_cast<Rotation>(*angle / quarter);
    return true;
}

bool read_colours(const kdl::Value& value, Draft& draft, Report& report)
{
    return assign(read_word(value, colour_words, report), draft.settings.panel.bgr);
}

bool read_inverted(const kdl::Value& value, Draft& draft, Report& report)
{
    return assign(read_flag(value, report), draft.settings.panel.inverted);
}

bool read_tearing(const kdl::Value& value, Draft& draft, Report& report)
{
    draft.tearing = read_flag(value, report);
    return draft.tearing.has_value();
}

bool read_column(const kdl::Value& value, Draft& draft, Report& report)
{
    return assign(read_whole_number(value, places, report), draft.settings.panel.column);
}

bool read_row(const kdl::Value& value, Draft& draft, Report& report)
{
    return assign(read_whole_number(value, places, report), draft.settings.panel.row);
}

bool read_brightness(const kdl::Value& value, Draft& draft, Report& report)
{
    const auto share = read_number(value, shares, report);
    if (share)
        draft.settings.panel.brightness = static_cast<std::uint8_t>(std::lround(*share * full_brightness));
    return share.has_value();
}

constexpr std::array rules{
    PropertyRule<Draft>{"rotation", read_rotation}, PropertyRule<Draft>{"colours", read_colours},
    PropertyRule<Draft>{"inverted", read_inverted}, PropertyRule<Draft>{"column", read_column},
    PropertyRule<Draft>{"row", read_row},           PropertyRule<Draft>{"brightness", read_brightness},
    PropertyRule<Draft>{"tearing", read_tearing},
};

/// Another glass than the usual one begins somewhere else, which only its seller knows.
bool read_glass(const kdl::Node& node, PanelSettings& panel, Report& report)
{
    if (node.arguments.size() == 1)
        return true;
    if (node.arguments.size() == 2)
        return report.error(node.arguments[1].place, "a panel has a width and a height",
                            "write panel st7789 or panel st7789 240 320");
    const auto width = read_whole_number(node.arguments[1], sides, report);
    const auto height = read_whole_number(node.arguments[2], sides, report);
    if (!width || !height)
        return false;
    const Size glass{*width, *height};
    if (glass != panel.glass)
        panel.column = panel.row = 0;
    panel.glass = glass;
    return true;
}

}

std::optional<Controller> read_controller(const kdl::Value& name, Report& report)
{
    if (const auto hint =
            name.string() == nullptr ? std::nullopt : fit::undriven_panel_text(*name.string())) {
        report.error(name.place, "unknown panel " + in_quotes(*name.string()), *hint);
        return std::nullopt;
    }
    return read_word(name, controller_words, report);
}

bool read_panel(const kdl::Node& node, Draft& draft, schema::Report& report)
{
    draft.panel = &node;
    const auto controller = read_controller(node.arguments.front(), report);
    PanelSettings& panel = draft.settings.panel;
    panel = facts_of(controller.value_or(Controller::st7789)).default_value;
    const bool has_glass = read_glass(node, panel, report);
    return read_properties(node, rules, draft, report) && has_glass && controller;
}

}
