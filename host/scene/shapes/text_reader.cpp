#include "host/scene/shapes/text_reader.hpp"

#include "core/scene/kfb_limits.hpp"
#include "host/geometry/drawing.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene/font/text_layout.hpp"
#include "host/scene/values/input_user.hpp"
#include "host/scene/values/text_properties.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

namespace kfast::scene {

namespace {

constexpr NodeForm label_form{"text", "text input=NAME at=\"X,Y\" size=PIXELS font=FONT"};

/// Converts `pixels` to the unit of advances, rounded to nearest, halves away from zero. What exceeds the
/// width of a label still exceeds it.
std::int32_t in_advance_units(double pixels)
{
    constexpr double max = 2.0 * kfb::max_text_width / kfb::advance_one;
    return static_cast<std::int32_t>(std::lround(std::clamp(pixels, -max, max) * kfb::advance_one));
}

/// Makes the glyphs of a label from the letters of its font.
class GlyphMaker {
public:
    GlyphMaker(const kdl::Node& node, const TextProperties& properties, SceneContext& context)
        : node_{node}, properties_{properties}, context_{context}
    {
        style_.at = {};
        style_.align = Align::left;
    }

    /// Nothing if it cannot be drawn, which is reported.
    std::optional<LabelGlyph> glyph(char32_t character, std::string_view input)
    {
        const Letter* const letter = style_.font->letter(character);
        std::string text;
        append_utf8(text, character);
        if (letter == nullptr) {
            report_missing(character, text, input);
            return std::nullopt;
        }
        LabelGlyph glyph{.drawing = {}, .advance = in_advance_units(scale() * letter->advance)};
        const auto outlines = set_text(text, style_, max_points);
        if (!outlines) {
            context_.report.error(node_.name_span, too_many_points());
            return std::nullopt;
        }
        for (const Outline& outline : *outlines)
            if (!add(outline, glyph.drawing))
                return std::nullopt;
        return glyph;
    }

    std::vector<Kerning> kerning(const std::u32string& characters) const
    {
        std::vector<Kerning> all;
        for (std::size_t left = 0; left < characters.size(); ++left)
            for (std::size_t right = 0; right < characters.size(); ++right) {
                const double by = scale() * style_.font->kerning(characters[left], characters[right]);
                if (const std::int32_t units = in_advance_units(by); units != 0)
                    all.push_back({static_cast<std::uint8_t>(left), static_cast<std::uint8_t>(right), units});
            }
        return all;
    }

private:
    double scale() const { return style_.size / style_.font->units_per_em(); }

    void report_missing(char32_t character, const std::string& text, std::string_view input)
    {
        context_.report.error(property_span(node_, "font"),
                              "the font " + in_quotes(properties_.font) + " has no " + in_words(text) +
                                  ", which the input " + in_quotes(input) + " may have",
                              other_font(character, context_));
    }

    bool add(const Outline& outline, Drawing& drawing)
    {
        if (!in_range(outline))
            return context_.report.error(node_.name_span, "a letter of this text is more than 2047 px large",
                                         "lower size=");
        if (!take_points(outline.curves.size() + 1, node_.name_span, context_))
            return false;
        drawing.strokes.push_back(quantized(outline));
        return true;
    }

    const kdl::Node& node_;
    const TextProperties& properties_;
    TextStyle style_ = properties_.style;
    SceneContext& context_;
};

/// The bound that the core uses, in the unit of advances.
std::int64_t widest_step(const Label& label)
{
    std::int64_t advance = 0;
    for (const LabelGlyph& glyph : label.glyphs)
        advance = std::max<std::int64_t>(advance, std::abs(glyph.advance));
    std::int64_t kerning = 0;
    for (const Kerning& pair : label.kerning)
        kerning = std::max<std::int64_t>(kerning, std::abs(pair.by));
    return advance + kerning + std::abs(std::int64_t{label.spacing});
}

bool has_capacity(const Label& label, const TextInput& input, const kdl::Node& node, SceneContext& context)
{
    return widest_step(label) * input.max <= kfb::max_text_width ||
           context.report.error(node.name_span,
                                "a text of " + std::to_string(input.max) +
                                    " characters may be more than 4095 px wide here",
                                "lower size=, or max= of the input");
}

}

bool is_label(const kdl::Node& node) { return node.name == label_form.name && has_property(node, "input"); }

void report_label_among_shapes(const kdl::Node& node, SceneContext& context)
{
    context.report.error(property_span(node, "input"),
                         "the text of an input is all that an object draws, and not in a key",
                         "give it an object of its own: object NAME fill=COLOUR { text input=… }");
}

std::optional<Label> read_label(const kdl::Node& node, SceneContext& context)
{
    if (!fits(node, label_form, context.report))
        return std::nullopt;
    const auto properties = read_text_properties(node, TextKind::label, context);
    if (!properties)
        return std::nullopt;
    const auto input = use_input(*properties->input, InputType::text, context);
    if (!input)
        return std::nullopt;
    note_lines(*properties, node.name_span, context);
    const Input& shown = context.inputs.entries[*input].input;
    const TextStyle& style = properties->style;
    Label label{.input = *input,
                .at = {to_sixteenths(style.at.x), to_sixteenths(style.at.y)},
                .align = style.align,
                .spacing = in_advance_units(style.spacing),
                .glyphs = {},
                .kerning = {}};
    GlyphMaker maker{node, *properties, context};
    for (const char32_t character : shown.text.glyphs) {
        auto glyph = maker.glyph(character, shown.name);
        if (!glyph || !take_points(1, node.name_span, context))
            return std::nullopt;
        label.glyphs.push_back(std::move(*glyph));
    }
    label.kerning = maker.kerning(shown.text.glyphs);
    if (!has_capacity(label, shown.text, node, context))
        return std::nullopt;
    return label;
}

NodeSchema label_schema()
{
    auto properties = text_property_schema(TextKind::label);
    std::ranges::find(properties, "input", &PropertySchema::name)->required = true;
    return {label_form.name, label_form, {}, properties};
}

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

NodeSchema text_schema()
{
    return {words_form.name, words_form, {any_text}, text_property_schema(TextKind::fixed)};
}

}
