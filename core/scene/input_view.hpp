#pragma once

#include "core/bytes/byte_reader.hpp"
#include "core/scene/format.hpp"
#include "core/scene/packed_drawing.hpp"
#include "core/time/time.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace kfast {

/// The characters that a text of a scene may have, each with a number, its glyph's; borrows the scene's bytes
/// (docs/format.md, "Inputs").
class GlyphSet {
public:
    GlyphSet() = default;
    /// Reads the set from `bytes`.
    static GlyphSet take(ByteReader& bytes);

    /// At most 255.
    std::uint32_t count() const { return count_; }
    /// The character's glyph; nothing if it is not one of them.
    std::optional<std::uint8_t> glyph(char32_t character) const;
    /// `glyph` is less than count(), and the set is valid.
    char32_t character(std::uint32_t glyph) const;
    /// Whether the format allows it: characters rise with their numbers.
    bool is_valid() const;

private:
    /// Characters that follow each other, as far as the next stretch.
    struct GlyphRange {
        std::uint32_t glyph; ///< of the first
        char32_t character;  ///< the first
    };

    std::uint32_t ranges() const
    {
        return static_cast<std::uint32_t>(ranges_.size() / kfb::glyph_range::bytes);
    }
    GlyphRange range(std::uint32_t number) const;
    /// The number of the glyph behind those of a stretch.
    std::uint32_t end_of(std::uint32_t number) const;

    std::uint32_t count_ = 0;
    std::span<const std::byte> ranges_;
};

enum class InputType : std::uint8_t {
    number,  ///< that keys may go by, and labels show
    text,    ///< that labels show
    drawing, ///< that live items show
};

/// What an input has that is a text.
struct TextInput {
    std::uint32_t max = 0;                    ///< characters
    GlyphSet glyphs = {};                     ///< of the characters that are shown; others are left out
    std::span<const std::byte> default_value; ///< the numbers of its glyphs, until another text is set
};

/// The limits of a drawing from outside, and the default until one is set.
struct DrawingInput {
    std::uint32_t strokes = 0;
    std::uint32_t points = 0;        ///< of all strokes together
    std::uint32_t default_value = 0; ///< offset in the section of drawings: lines, within these limits
};

/// An input of a scene; borrows the scene's bytes. Values of a number are in 1/1000.
struct InputView {
    std::string_view name; ///< UTF-8
    InputType type = InputType::number;
    std::int32_t min = 0;
    std::int32_t max = 0;           ///< more than `min`, of a number
    std::int32_t default_value = 0; ///< until another is set
    TextInput text = {};            ///< only of a text
    DrawingInput drawing{};         ///< only of a drawing

    /// The place of the input at `value`, clamped to its range; rounded to nearest, halves up. 0 unless it is
    /// a number.
    Time place_of(std::int32_t value) const;
};

/// Reads the inputs of a scene in their order.
class InputCursor {
public:
    InputCursor(ByteReader bytes, std::uint32_t count) : bytes_{bytes}, left_{count} {}

    bool at_end() const { return left_ == 0; }
    /// Only when not at the end. An input of an unknown kind is past the end.
    InputView next();
    /// What has not been read.
    const ByteReader& rest() const { return bytes_; }

private:
    ByteReader bytes_;
    std::uint32_t left_;
};

/// Fills `places` with the default places of the inputs; there are as many of both. An input that is no
/// number is at 0.
void put_default_places(InputCursor inputs, std::span<Time> places);

/// On which side of its position a line of text is.
enum class Align : std::uint8_t { left, center, right };

/// How a label writes a number; borrows the scene's bytes. At most kfb::max_text glyphs come of it.
struct NumberFormat {
    std::uint32_t decimals = 0; ///< 0 … kfb::max_decimals
    std::uint32_t digits =
        1; ///< before the point: at least so many, 1 … kfb::max_digits, with zeros in front
    std::uint32_t places = 0;          ///< likewise, 0 … kfb::max_digits, with gaps in front of the digits
    std::span<const std::byte> before; ///< the glyphs in front of the number
    std::span<const std::byte> behind;

    /// Reads one from `bytes`.
    static NumberFormat take(ByteReader& bytes);
};

/// How the text or the number of an input is laid out on one line; borrows the scene's bytes (docs/format.md,
/// "Live items"). Widths are in 1/4096 px.
struct LabelView {
    Align align = Align::left;
    bool shows_number = false;
    std::int32_t x = 0; ///< of the position on the baseline that `align` is about, in 1/16 px
    std::int32_t y = 0;
    std::int32_t spacing = 0;         ///< added between glyphs
    std::uint32_t glyph_count = 0;    ///< that of the input's glyphs, if it is a text
    PackedValues drawings;            ///< of each glyph, offsets in the section of drawings
    PackedValues advances;            ///< of each glyph, the distance to the beginning of the next
    std::span<const std::byte> pairs; ///< see pair_code()
    PackedValues kerning;             ///< of each pair, what is added between them
    NumberFormat format = {};         ///< only if it shows a number

    bool is_whole = false; ///< the bytes ended neither before nor after its end, and no bit is unknown

    /// `bytes` are those of one label.
    static LabelView of(ByteReader bytes);

    std::uint32_t pair_count() const
    {
        return static_cast<std::uint32_t>(pairs.size() / kfb::kerning::bytes);
    }
    /// The two glyphs of a pair as one number, by which pairs are ordered: 256 x the left one + the right
    /// one.
    std::uint32_t pair_code(std::uint32_t number) const;
    /// What is added between two glyphs besides the spacing.
    std::int32_t kerning_between(std::uint32_t left, std::uint32_t right) const;
};

}
