#pragma once

#include "core/bytes/byte_reader.hpp"
#include "core/scene/packed_values.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// On which side of its place a line of text lies.
enum class Align : std::uint8_t { left, center, right };

/// How the text of an input is laid out on one line; borrows the scene's bytes (docs/format.md, "Labels").
/// Widths are in 1/4096 px.
struct LabelView {
    Align align = Align::left;
    std::int32_t x = 0; ///< of the place on the baseline that `align` says, in 1/16 px
    std::int32_t y = 0;
    std::int32_t spacing = 0;         ///< added between glyphs
    std::uint32_t glyph_count = 0;    ///< that of the input's glyphs
    PackedValues drawings;            ///< of each glyph, offsets in the section of drawings
    PackedValues advances;            ///< of each glyph, how far from its beginning the next one begins
    std::span<const std::byte> pairs; ///< see pair_code()
    PackedValues kerning;             ///< of each pair, what is added between them

    bool is_whole = false; ///< the bytes ended neither before it nor behind it

    /// `bytes` are those of one label.
    static LabelView of(ByteReader bytes);

    std::uint32_t pair_count() const { return static_cast<std::uint32_t>(pairs.size() / 2); }
    /// The two glyphs of a pair as one number, by which pairs are ordered: 256 x the left one + the right
    /// one.
    std::uint32_t pair_code(std::uint32_t number) const;
    /// What is added between two glyphs beside the spacing.
    std::int32_t kerning_between(std::uint32_t left, std::uint32_t right) const;
};

}
