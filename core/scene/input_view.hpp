#pragma once

#include "core/bytes/byte_reader.hpp"
#include "core/scene/glyph_set.hpp"
#include "core/time/time.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace kfast {

enum class InputType : std::uint8_t {
    number,  ///< that keys may go by
    text,    ///< that labels show
    drawing, ///< that live items show
};

/// What of an input is a text.
struct TextInput {
    std::uint32_t max = 0;                    ///< characters
    GlyphSet glyphs = {};                     ///< of the characters that are shown; others are left out
    std::span<const std::byte> default_value; ///< the numbers of its glyphs, until another text is set
};

/// What a drawing from outside may have, and what it is until one comes.
struct DrawingInput {
    std::uint32_t strokes = 0;
    std::uint32_t points = 0;        ///< of all strokes together
    std::uint32_t default_value = 0; ///< offset in the section of drawings: lines, no more than that
};

/// What a scene takes from outside; borrows the scene's bytes. Values of a number are in 1/1000.
struct InputView {
    std::string_view name; ///< UTF-8
    InputType type = InputType::number;
    std::int32_t min = 0;
    std::int32_t max = 0;           ///< more than `min`, of a number
    std::int32_t default_value = 0; ///< until another is set
    TextInput text = {};            ///< only of a text
    DrawingInput drawing{};         ///< only of a drawing

    /// Where the input stands with `value`, held within its range; rounded to nearest, halves up. 0 unless it
    /// is a number.
    Time place_of(std::int32_t value) const;
};

/// Reads the inputs of a scene in their order.
class InputCursor {
public:
    InputCursor(ByteReader bytes, std::uint32_t count) : bytes_{bytes}, left_{count} {}

    bool at_end() const { return left_ == 0; }
    /// Only when not at the end. What is of an unknown kind is past the end.
    InputView next();
    /// What has not been read.
    const ByteReader& rest() const { return bytes_; }

private:
    ByteReader bytes_;
    std::uint32_t left_;
};

/// Puts into `places` where the inputs stand until others are set; there are as many of both. What is no
/// number stands at 0.
void put_default_places(InputCursor inputs, std::span<Time> places);

}
