#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

namespace kfast::schema {

/// Both ends are inside.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
};

enum class ValueType : std::uint8_t {
    none, ///< unspecified
    number,
    whole_number,
    time,
    moment, ///< a time, or a value of the input that drives its node
    colour,
    name,
    text,
    word, ///< one of a few
    truth,
    law,
    spot, ///< a text "X,Y"
    path, ///< a text with the data of a path
    font, ///< the name of a bundled one, or of a file
};

/// One of the words that a property takes.
template <class Meaning>
struct Word {
    std::string_view name;
    Meaning meaning;
};

/// The names of a table of words.
template <const auto& words>
inline constexpr auto word_names = [] {
    std::array<std::string_view, words.size()> names;
    for (std::size_t i = 0; i < words.size(); ++i)
        names[i] = words[i].name;
    return names;
}();

/// The expected kind of a value, for those that write scenes and for their tools.
struct ValueKind {
    ValueType type = ValueType::none;
    Range range = {};           ///< of numbers
    std::string_view unit = {}; ///< of numbers: "px" or "degrees"
    std::span<const std::string_view> words = {};

    static constexpr ValueKind number(Range range) { return {ValueType::number, range, {}, {}}; }
    static constexpr ValueKind whole(Range range) { return {ValueType::whole_number, range, {}, {}}; }
    static constexpr ValueKind pixels(Range range) { return {ValueType::number, range, "px", {}}; }
    static constexpr ValueKind degrees(Range range) { return {ValueType::number, range, "degrees", {}}; }
    static constexpr ValueKind plain(ValueType type) { return {type, {}, {}, {}}; }
    /// `words` is a table of Word.
    template <const auto& words>
    static constexpr ValueKind one_of()
    {
        return {ValueType::word, {}, {}, word_names<words>};
    }
};

inline constexpr ValueKind any_time = ValueKind::plain(ValueType::time);
inline constexpr ValueKind any_moment = ValueKind::plain(ValueType::moment);
inline constexpr ValueKind any_colour = ValueKind::plain(ValueType::colour);
inline constexpr ValueKind any_name = ValueKind::plain(ValueType::name);
inline constexpr ValueKind any_text = ValueKind::plain(ValueType::text);
inline constexpr ValueKind truth = ValueKind::plain(ValueType::truth);
inline constexpr ValueKind any_law = ValueKind::plain(ValueType::law);
inline constexpr ValueKind any_spot = ValueKind::plain(ValueType::spot);
inline constexpr ValueKind any_path = ValueKind::plain(ValueType::path);
inline constexpr ValueKind any_font = ValueKind::plain(ValueType::font);

}
