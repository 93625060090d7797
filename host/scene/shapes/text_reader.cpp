#include "host/scene/shapes/text_reader.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/font/text_layout.hpp"
#include "host/scene/shapes/label_reader.hpp"
#include "host/scene/values/text_properties.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/node_schema.hpp"
#include "host/text/glyph.hpp"

namespace kfast::scene {
namespace {

constexpr NodeForm words_form{"text", "text \"WORDS\" at=\"X,Y\" size=PIXELS font=FONT", 1, 1};

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

std::vector<Outline> read_text_shape(const kdl::Node& node, std::size_t points_left, SceneContext& context)
{
    if (is_label(node)) {
        report_label_among_shapes(node, context);
        return {};
    }
    if (!fits(node, words_form, context.report))
        return {};
    const kdl::Value& value = node.arguments.front();
    const auto properties = read_text_properties(node, TextKind::fixed, context);
    const auto text = read_text(value, context.report);
    if (!properties || !text || !has_letters(value, *text, *properties, context))
        return {};
    note_lines(*properties, value.place, context);
    auto outlines = set_text(*text, properties->style, points_left);
    if (!outlines)
        context.report.error(value.place, too_many_points());
    else if (outlines->empty())
        context.report.warning(value.place, "this text draws nothing");
    return std::move(outlines).value_or(std::vector<Outline>{});
}

NodeSchema text_words()
{
    return {words_form.name, words_form, {any_text}, text_property_words(TextKind::fixed)};
}

}
