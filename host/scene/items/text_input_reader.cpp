#include "host/scene/items/input_reader.hpp"

#include "core/bytes/code_point.hpp"
#include "core/scene/kfb_limits.hpp"
#include "host/scene/values/text_properties.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/characters.hpp"

#include <array>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace kfast::scene {
namespace {

constexpr Range lengths{1, kfb::max_text};

struct TextInputProperties {
    const kdl::Value* glyphs = nullptr;
    const kdl::Value* default_value = nullptr;
    int max = 0;
};

template <auto TextInputProperties::*value>
bool keep_value(const kdl::Value& written, TextInputProperties& input, SceneContext& context)
{
    input.*value = &written;
    return read_text(written, context.report).has_value();
}

bool read_max(const kdl::Value& written, TextInputProperties& input, SceneContext& context)
{
    return assign(read_whole_number(written, lengths, context.report), input.max);
}

constexpr std::array text_input_rules{
    PropertyRule<TextInputProperties>{"kind", check_own_type<TextInputProperties>,
                                      ValueKind::one_of<input_types>()},
    PropertyRule<TextInputProperties>{"glyphs", keep_value<&TextInputProperties::glyphs>, any_text, true},
    PropertyRule<TextInputProperties>{"max", read_max, ValueKind::whole(lengths), true},
    PropertyRule<TextInputProperties>{"default", keep_value<&TextInputProperties::default_value>, any_text},
};

/// A character and its position in its text.
struct PlacedCharacter {
    char32_t value = 0;
    SourceSpan place;
};

std::vector<PlacedCharacter> characters_of(std::string_view text)
{
    std::vector<PlacedCharacter> characters;
    for (std::size_t at = 0; at < text.size();) {
        const CodePoint point = code_point_at(text, at);
        characters.push_back({point.value, {at, point.length}});
        at += point.length;
    }
    return characters;
}

bool is_control(char32_t character) { return character < 0x20 || (character >= 0x7F && character < 0xA0); }

/// Reads characters and ranges of them. Between a first and a last character, "-" means all between;
/// elsewhere it is itself.
class GlyphReader {
public:
    GlyphReader(const kdl::Value& value, SceneContext& context) : value_{value}, context_{context} {}

    /// Includes the space; nothing if something is wrong, which is reported.
    std::optional<std::u32string> read()
    {
        const auto written = characters_of(*value_.string());
        if (written.empty())
            return refuse({}, "this input has no characters",
                          "write those that it may have, as in \"0-9:%\"");
        for (std::size_t i = 0; i < written.size();) {
            const bool is_range = i + 2 < written.size() && written[i + 1].value == U'-';
            if (!add(written[i], is_range ? written[i + 2] : written[i]))
                return std::nullopt;
            i += is_range ? 3 : 1;
        }
        return std::u32string(characters_.begin(), characters_.end());
    }

private:
    bool add(const PlacedCharacter& first, const PlacedCharacter& last)
    {
        const SourceSpan place = span(first.place, last.place);
        for (const PlacedCharacter& end : {first, last})
            if (is_control(end.value))
                return refuse(end.place, "a text is one line of visible characters", "leave this one out")
                    .has_value();
        if (last.value < first.value)
            return refuse(place, "this range runs backwards",
                          "write the character with the lower code first; a \"-\" itself stands at the end")
                .has_value();
        for (char32_t character = first.value;
             character <= last.value && characters_.size() <= kfb::max_glyphs; ++character)
            if (is_scalar_value(character) && !is_control(character))
                characters_.insert(character);
        if (characters_.size() <= kfb::max_glyphs)
            return true;
        return refuse(place,
                      "a text has at most " + std::to_string(kfb::max_glyphs) +
                          " different characters, the space among them",
                      "leave some of them out")
            .has_value();
    }

    std::optional<std::u32string> refuse(SourceSpan place, std::string message, std::string hint)
    {
        context_.report.error(place.length == 0 ? value_.place : place_in_text(value_, place),
                              std::move(message), std::move(hint));
        return std::nullopt;
    }

    const kdl::Value& value_;
    SceneContext& context_;
    std::set<char32_t> characters_{U' '};
};

std::u32string read_default(const kdl::Value& value, const TextInput& input, SceneContext& context)
{
    const std::string& text = *value.string();
    std::u32string default_value;
    for (const PlacedCharacter& character : characters_of(text)) {
        if (input.glyphs.find(character.value) == std::u32string::npos) {
            context.report.error(place_in_text(value, character.place),
                                 "this input has no " + in_words(std::string_view{text}.substr(
                                                            character.place.offset, character.place.length)),
                                 "add it to glyphs=");
            return {};
        }
        default_value += character.value;
    }
    if (default_value.size() <= input.max)
        return default_value;
    context.report.error(value.place, "this text has " + std::to_string(default_value.size()) + " characters",
                         "allowed: up to " + std::to_string(input.max) + ", by max=");
    return {};
}

}

TextInput read_text_input(const kdl::Node& node, SceneContext& context)
{
    TextInputProperties properties;
    TextInput input{.glyphs = U" ", .max = 1, .default_value = {}};
    if (!read_properties(node, text_input_rules, properties, context))
        return input;
    input.max = static_cast<std::uint32_t>(properties.max);
    const auto glyphs = GlyphReader{*properties.glyphs, context}.read();
    if (!glyphs)
        return input;
    input.glyphs = *glyphs;
    if (properties.default_value != nullptr)
        input.default_value = read_default(*properties.default_value, input, context);
    return input;
}

std::vector<PropertySchema> text_input_schema() { return schema_of(text_input_rules); }

}
