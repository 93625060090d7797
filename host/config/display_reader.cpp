#include "host/config/display_reader.hpp"

#include "core/player.hpp"
#include "firmware/settings/controller_facts.hpp"
#include "host/beam/beam_text.hpp"
#include "host/config/setting_words.hpp"
#include "host/fit/other_hardware.hpp"
#include "host/schema/property_rule.hpp"
#include "host/schema/value_reader.hpp"
#include "host/text/characters.hpp"

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

constexpr std::array panel_rules{
    PropertyRule<Draft>{"rotation", read_rotation}, PropertyRule<Draft>{"colours", read_colours},
    PropertyRule<Draft>{"inverted", read_inverted}, PropertyRule<Draft>{"column", read_column},
    PropertyRule<Draft>{"row", read_row},           PropertyRule<Draft>{"brightness", read_brightness},
    PropertyRule<Draft>{"tearing", read_tearing},
};

/// Another glass than the default one begins somewhere else, which only its seller knows.
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
    return read_properties(node, panel_rules, draft, report) && has_glass && controller;
}

namespace {

using schema::assign, schema::PropertyRule, schema::Range, schema::Report;

constexpr Range clocks{1, 1e9};
constexpr Range bytes{0, 0xFF}; // the panel_rules check which addresses there are

constexpr std::array bus_words = named_words<BusKind>(bus_names);

bool read_clock(const kdl::Value& value, Draft& draft, Report& report)
{
    const auto clock = read_quantity(value, schema::frequency, clocks, report);
    if (clock)
        draft.clock = static_cast<std::uint32_t>(std::lround(*clock));
    return clock.has_value();
}

bool read_address(const kdl::Value& value, Draft& draft, Report& report)
{
    return assign(read_whole_number(value, bytes, report), draft.settings.i2c_address);
}

constexpr std::array bus_rules{
    PropertyRule<Draft>{"clock", read_clock},
    PropertyRule<Draft>{"address", read_address},
};

}

bool read_bus(const kdl::Node& node, Draft& draft, schema::Report& report)
{
    draft.bus = &node;
    const bool is_known = assign(read_word(node.arguments.front(), bus_words, report), draft.settings.bus);
    if (is_known && draft.settings.bus != BusKind::i2c && schema::has_property(node, "address"))
        report.warning(schema::property_span(node, "address"), "only i2c has addresses", "remove it");
    return read_properties(node, bus_rules, draft, report) && is_known;
}

bool read_beam_part(const kdl::Node& node, Draft& draft, schema::Report& report)
{
    draft.beam = &node;
    return schema::assign(read_beam(node, report), draft.settings.beam);
}

bool check_display(const kdl::Node& board, const Draft& draft, schema::Report& report)
{
    if (draft.beam == nullptr && draft.panel == nullptr)
        return report.error(board.name_span, "board has neither a panel nor a beam",
                            "add \"panel st7789\", or \"beam scope\" for a vector display");
    if (draft.beam != nullptr && draft.panel != nullptr)
        return report.error(draft.beam->name_span, "a board has a panel or a beam, not both",
                            "remove one of them");
    if (draft.bus == nullptr)
        return false; // which was reported
    const bool leads = leads_beam(draft.settings.bus);
    const SourceSpan bus = draft.bus->arguments.front().place;
    if (leads && draft.beam == nullptr)
        return report.error(bus, "bus dac leads a beam, and there is a panel",
                            "write another bus, or a beam in place of the panel");
    if (!leads && draft.beam != nullptr)
        return report.error(bus, word_of(draft.settings.bus) + " cannot lead a beam", "write bus dac");
    return true;
}

}
