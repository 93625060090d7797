#include "host/scene/shapes/text_reader.hpp"

#include "host/scene/font/text_layout.hpp"
#include "host/scene/shapes/label_reader.hpp"
#include "host/scene/values/text_properties.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/characters.hpp"
#include "host/text/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kfast::scene {

namespace {

constexpr NodeForm words_form{"text", "text \"WORDS\" at=\"X,Y\" size=PIXELS font=FONT", 1, 1};
constexpr NodeForm path_form{"text", "text \"WORDS\" along=\"M …\" size=PIXELS font=FONT", 1, 1};

/// The first character of `text` that `font` lacks.
std::optional<SourceSpan> first_missing(std::string_view text, Font& font)
{
    for (std::size_t at = 0; at < text.size();) {
        const CodePoint point = code_point_at(text, at);
        if (point.value != U'\n' && font.letter(point.value) == nullptr)
            return SourceSpan{at, point.length};
        at += point.length;
    }
    return std::nullopt;
}

bool has_letters(const kdl::Value& value, std::string_view text, const TextProperties& properties,
                 SceneContext& context)
{
    const auto missing = first_missing(text, *properties.style.font);
    if (!missing)
        return true;
    const std::string_view letter = text.substr(missing->offset, missing->length);
    return context.report.error(place_in_text(value, *missing),
                                "the font " + in_quotes(properties.font) + " has no " + in_words(letter),
                                other_font(code_point_at(letter, 0).value, context));
}

}

namespace {

/// What does not go with a path, and why.
struct Superseded {
    std::string_view property;
    std::string_view reason;
};

constexpr std::array superseded_by_path{
    Superseded{"at", "along=… says where this text is, in the place of at"},
    Superseded{"vertical", "a text along a path stands on it, and is not moved across it"},
    Superseded{"leading", "a text along a path has one line"},
};

bool goes_with_path(const kdl::Node& node, SceneContext& context)
{
    bool good = true;
    for (const Superseded& superseded : superseded_by_path)
        if (has_property(node, superseded.property))
            good =
                context.report.error(property_span(node, superseded.property), std::string{superseded.reason},
                                     "remove " + std::string{superseded.property} + "=… or along=…");
    return good;
}

/// Refuses several lines, and warns of a line that leads beyond an end of the path.
bool fits_path(const kdl::Value& value, std::string_view text, const TextStyle& style, SceneContext& context)
{
    const auto lines = lines_of(text);
    if (lines.size() > 1)
        return context.report.error(value.place, "a text along a path has one line",
                                    "write a text for each line, along paths beside each other");
    const double length = style.along->length();
    const double width = width_of(lines.front(), style);
    const double begin = style.start - share_left_of_anchor(style.align) * width;
    const double beyond = style.along->is_closed()
                              ? width - length
                              : std::max(-begin, 0.0) + std::max(begin + width - length, 0.0);
    if (beyond >= 0.5)
        context.report.warning(
            value.place,
            counted(static_cast<std::size_t>(std::lround(beyond)), "pixel") +
                " of this text lie beyond its path",
            "lower size=, let it begin elsewhere by start= and align=, or draw a longer path");
    return true;
}

}

std::vector<Outline> read_text_shape(const kdl::Node& node, std::size_t points_left, SceneContext& context)
{
    if (is_label(node)) {
        report_label_among_shapes(node, context);
        return {};
    }
    const bool is_on_path = has_property(node, "along");
    if (!fits(node, is_on_path ? path_form : words_form, context.report) ||
        (is_on_path && !goes_with_path(node, context)))
        return {};
    const kdl::Value& value = node.arguments.front();
    const auto properties =
        read_text_properties(node, is_on_path ? TextKind::on_path : TextKind::fixed, context);
    const auto text = read_text(value, context.report);
    if (!properties || !text || !has_letters(value, *text, *properties, context) ||
        (is_on_path && !fits_path(value, *text, properties->style, context)))
        return {};
    note_lines(*properties, value.place, context);
    auto outlines = set_text(*text, properties->style, points_left);
    if (!outlines)
        context.report.error(value.place, too_many_points());
    else if (outlines->empty())
        context.report.warning(value.place, "this text draws nothing");
    return std::move(outlines).value_or(std::vector<Outline>{});
}

NodeSchema text_schema()
{
    return {words_form.name, words_form, {any_text}, text_property_schema(TextKind::fixed)};
}

NodeSchema path_text_schema()
{
    auto properties = text_property_schema(TextKind::on_path);
    std::ranges::find(properties, "along", &PropertySchema::name)->required = true;
    return {path_form.name, path_form, {any_text}, properties};
}

}
