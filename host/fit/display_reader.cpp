#include "host/fit/display_reader.hpp"

#include "core/player.hpp"
#include "host/fit/other_hardware.hpp"
#include "host/picture/panel_choice.hpp"
#include "host/schema/property_rule.hpp"
#include "host/schema/value_reader.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace kfast::fit {
namespace {

using schema::assign, schema::PropertyRule, schema::Range, schema::Report;

constexpr Range sides{1, Player::max_panel};
constexpr Range window_bytes{0, 64};

bool read_format(const kdl::Value& value, Display& display, Report& report)
{
    const auto name = read_text(value, report);
    if (!name)
        return false;
    const auto format = std::ranges::find(format_names(), *name, &FormatName::name);
    if (format == format_names().end()) {
        std::vector<std::string_view> known;
        std::ranges::transform(format_names(), std::back_inserter(known), &FormatName::name);
        report_unknown_word(value, *name, known, report);
        return false;
    }
    display = taking(format->value, display);
    return true;
}

bool read_window(const kdl::Value& value, Display& display, Report& report)
{
    return assign(read_whole_number(value, window_bytes, report), display.window_bytes);
}

constexpr std::array rules{
    PropertyRule<Display>{"format", read_format},
    PropertyRule<Display>{"window", read_window},
};

std::optional<Display> named_display(const kdl::Value& value, Report& report)
{
    const auto name = read_text(value, report);
    if (!name)
        return std::nullopt;
    if (const Display* const display = display_named(*name))
        return *display;
    const std::string hint = other_panel_text(*name).value_or(
        display_suggestion(*name) + ", or describe it: panel 240 240 format=rgb565");
    report.error(value.place, "unknown panel " + in_quotes(*name), hint);
    return std::nullopt;
}

bool read_size(std::span<const kdl::Value> values, Display& display, Report& report)
{
    const auto width = read_whole_number(values[0], sides, report);
    const auto height = read_whole_number(values[1], sides, report);
    if (!width || !height)
        return false;
    display.size = {*width, *height};
    return true;
}

bool is_in_steps(const kdl::Node& node, const Display& display, Report& report)
{
    const Size step = display.granularity;
    if (display.size.width % step.width == 0 && display.size.height % step.height == 0)
        return true;
    return report.error(node.name_span,
                        "the bytes of this panel hold " + std::to_string(step.width) + " x " +
                            std::to_string(step.height) + " pixels",
                        "let its sides be multiples of that");
}

}

std::optional<Display> read_display(const kdl::Node& node, Report& report)
{
    std::span<const kdl::Value> values = node.arguments;
    std::optional<Display> display = Display{};
    const bool is_named = !values.empty() && values.front().string() != nullptr;
    if (is_named) {
        display = named_display(values.front(), report);
        values = values.subspan(1);
    }
    if (!display)
        return std::nullopt;
    if (values.size() != 2 && !(is_named && values.empty())) {
        report.error(node.name_span, "a panel has a width and a height",
                     "write panel st7789, panel st7789 240 320 or panel 240 240 format=rgb565");
        return std::nullopt;
    }
    const bool has_size = values.empty() || read_size(values, *display, report);
    if (!read_properties(node, rules, *display, report) || !has_size || !is_in_steps(node, *display, report))
        return std::nullopt;
    return display;
}

}
