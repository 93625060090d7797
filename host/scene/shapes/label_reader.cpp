#include "host/scene/shapes/label_reader.hpp"

#include "core/scene/format.hpp"
#include "core/scene/kfb_limits.hpp"
#include "core/scene/number_text.hpp"
#include "host/geometry/drawing.hpp"
#include "host/scene/context/limits.hpp"
#include "host/scene/font/text_layout.hpp"
#include "host/scene/values/input_user.hpp"
#include "host/scene/values/number_pattern.hpp"
#include "host/scene/values/text_properties.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>
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

    bool has(char32_t character) const { return style_.font->letter(character) != nullptr; }

    /// Nothing if it cannot be drawn, which is reported. `use` says why it is needed.
    std::optional<LabelGlyph> glyph(char32_t character, const std::string& use)
    {
        const Letter* const letter = style_.font->letter(character);
        std::string text;
        append_utf8(text, character);
        if (letter == nullptr) {
            report_missing(character, text, use);
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

    void report_missing(char32_t character, const std::string& text, const std::string& use)
    {
        context_.report.error(property_span(node_, "font"),
                              "the font " + in_quotes(properties_.font) + " has no " + in_words(text) + use,
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

bool has_capacity(const Label& label, std::uint32_t characters, const kdl::Node& node, SceneContext& context)
{
    return widest_step(label) * characters <= kfb::max_text_width ||
           context.report.error(node.name_span,
                                "a text of " + std::to_string(characters) +
                                    " characters may be more than 4095 px wide here",
                                label.format ? "lower size=" : "lower size=, or max= of the input");
}

/// Adds the glyphs of a text, `shown`. Returns whether the label can show it.
bool add_text(const Input& shown, const kdl::Node& node, GlyphMaker& maker, Label& label,
              SceneContext& context)
{
    for (const char32_t character : shown.text.glyphs) {
        auto glyph = maker.glyph(character, ", which the input " + in_quotes(shown.name) + " may have");
        if (!glyph || !take_points(1, node.name_span, context))
            return false;
        label.glyphs.push_back(std::move(*glyph));
    }
    label.kerning = maker.kerning(shown.text.glyphs);
    return has_capacity(label, shown.text.max, node, context);
}

/// The glyphs of numbers in their order (kfb::number_glyph), and those around them.
class NumberGlyphs {
public:
    NumberGlyphs(GlyphMaker& maker, Label& label) : maker_{maker}, label_{label} {}

    /// Returns whether the font has them.
    bool add(const NumberPattern& pattern, bool may_be_negative)
    {
        bool good = true;
        for (char32_t digit = U'0'; digit <= U'9'; ++digit)
            good = add(digit, true) && good;
        constexpr char32_t minus = 0x2212;
        good = add(maker_.has(minus) ? minus : U'-', may_be_negative) && good;
        good = add(pattern.point, pattern.decimals != 0) && good;
        label_.glyphs.push_back(
            {.drawing = {}, .advance = good ? label_.glyphs.front().advance : 0}); // the gap
        label_.format = {.decimals = pattern.decimals,
                         .digits = pattern.digits,
                         .places = pattern.places,
                         .before = numbers_of(pattern.before, good),
                         .behind = numbers_of(pattern.behind, good)};
        return good;
    }

private:
    bool add(char32_t character, bool is_needed)
    {
        auto glyph =
            is_needed ? maker_.glyph(character, ", which this number has") : std::optional{LabelGlyph{}};
        const bool good = glyph.has_value();
        label_.glyphs.push_back(std::move(glyph).value_or(LabelGlyph{}));
        return good;
    }

    /// Adds those that are not there yet.
    std::vector<std::uint8_t> numbers_of(const std::u32string& characters, bool& good)
    {
        std::vector<std::uint8_t> numbers;
        for (const char32_t character : characters) {
            const std::size_t known = others_.find(character);
            if (known == others_.npos) {
                good = add(character, true) && good;
                others_ += character;
            }
            const std::size_t number = std::min(known, others_.size() - 1);
            numbers.push_back(static_cast<std::uint8_t>(kfb::number_glyph::first_other + number));
        }
        return numbers;
    }

    GlyphMaker& maker_;
    Label& label_;
    std::u32string others_;
};

std::uint32_t longest(const Label& label, const Input& shown)
{
    const std::vector<std::uint8_t>& before = label.format->before;
    const std::vector<std::uint8_t>& behind = label.format->behind;
    return max_glyphs({.decimals = label.format->decimals,
                       .digits = label.format->digits,
                       .places = label.format->places,
                       .before = std::as_bytes(std::span{before}),
                       .behind = std::as_bytes(std::span{behind})},
                      InputView{.name = {}, .min = shown.min, .max = shown.max});
}

/// The same of a number. Digits are not kerned, so that they stay where they are.
bool add_number(const Input& shown, const kdl::Value* format, const kdl::Node& node, GlyphMaker& maker,
                Label& label, SceneContext& context)
{
    const auto pattern = format == nullptr ? NumberPattern{} : read_number_pattern(*format, context);
    return pattern && NumberGlyphs{maker, label}.add(*pattern, shown.min < 0) &&
           take_points(label.glyphs.size(), node.name_span, context) &&
           has_capacity(label, longest(label, shown), node, context);
}

/// Reports a path; the input counts as used then.
bool has_no_path(const kdl::Node& node, SceneContext& context)
{
    if (!has_property(node, "along"))
        return true;
    const auto name = std::ranges::find(node.properties, "input", &kdl::Property::name);
    const auto input = use_label_input(name->value, context);
    const bool is_number = input && context.inputs.entries[*input].input.type == InputType::number;
    return context.report.error(property_span(node, "along"),
                                std::string{is_number ? "a number" : "the text of an input"} +
                                    " does not follow a path",
                                "write at=\"X,Y\" in the place of along=…");
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
    if (!fits(node, label_form, context.report) || !has_no_path(node, context))
        return std::nullopt;
    const auto properties = read_text_properties(node, TextKind::label, context);
    if (!properties)
        return std::nullopt;
    const auto input = use_label_input(*properties->input, context);
    if (!input)
        return std::nullopt;
    note_lines(*properties, node.name_span, context);
    const Input& shown = context.inputs.entries[*input].input;
    const TextStyle& style = properties->style;
    Label label{.input = *input,
                .at = {to_sixteenths(style.at.x), to_sixteenths(style.first_baseline(1))},
                .pivot = {to_sixteenths(style.at.x), to_sixteenths(style.at.y)},
                .align = style.align,
                .spacing = in_advance_units(style.spacing),
                .glyphs = {},
                .kerning = {}};
    GlyphMaker maker{node, *properties, context};
    const bool is_number = shown.type == InputType::number;
    if (!is_number && properties->format != nullptr)
        context.report.error(property_span(node, "format"), "only a number has a format",
                             "remove it, or let the input be a number");
    const bool good = is_number ? add_number(shown, properties->format, node, maker, label, context)
                                : add_text(shown, node, maker, label, context);
    return good ? std::optional{std::move(label)} : std::nullopt;
}

NodeSchema label_schema()
{
    auto properties = text_property_schema(TextKind::label);
    std::ranges::find(properties, "input", &PropertySchema::name)->required = true;
    return {label_form.name, label_form, {}, properties};
}

}
