#include "host/scene/text_reader.hpp"

#include "host/scene/label_reader.hpp"
#include "host/scene/limits.hpp"
#include "host/scene/node_form.hpp"
#include "host/scene/node_words.hpp"
#include "host/scene/text_layout.hpp"
#include "host/scene/text_properties.hpp"
#include "host/scene/value_reader.hpp"
#include "host/text/glyph.hpp"

namespace kfast::scene {
namespace {

constexpr NodeForm words_form{"text", "text \"WORDS\" at=\"X,Y\" size=PIXELS font=FONT", 1, 1};

/// The first character of `text` that `font` lacks.
std::optional<Place> first_missing(std::string_view text, Font& font)
{
    for (std::size_t at = 0; at < text.size();) {
        const CodePoint point = code_point_at(text, at);
        if (point.value != U'\n' && font.letter(point.value) == nullptr)
            return Place{at, point.length};
        at += point.length;
    }
    return std::nullopt;
}

bool has_letters(const kdl::Value& value, std::string_view text, const TextProperties& properties,
                 Reading& reading)
{
    const auto missing = first_missing(text, *properties.style.font);
    if (!missing)
        return true;
    const std::string_view letter = text.substr(missing->offset, missing->length);
    return reading.report.error(place_in_text(value, *missing),
                                "the font " + in_quotes(properties.font) + " has no " + in_words(letter),
                                other_font(code_point_at(letter, 0).value, reading));
}

}

std::vector<Outline> read_text_shape(const kdl::Node& node, std::size_t points_left, Reading& reading)
{
    if (is_label(node)) {
        report_label_among_shapes(node, reading);
        return {};
    }
    if (!fits(node, words_form, reading))
        return {};
    const kdl::Value& value = node.arguments.front();
    const auto properties = read_text_properties(node, TextKind::fixed, reading);
    const auto text = read_text(value, reading);
    if (!properties || !text || !has_letters(value, *text, *properties, reading))
        return {};
    note_lines(*properties, value.place, reading);
    auto outlines = set_text(*text, properties->style, points_left);
    if (!outlines)
        reading.report.error(value.place, too_many_points());
    else if (outlines->empty())
        reading.report.warning(value.place, "this text draws nothing");
    return std::move(outlines).value_or(std::vector<Outline>{});
}

NodeWords text_words()
{
    return {words_form.name, words_form, {any_text}, text_property_words(TextKind::fixed)};
}

}
