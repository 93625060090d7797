#pragma once

#include "core/bytes/byte_reader.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace kfast {

/// The characters that a text of a scene may have, each with a number, its glyph's; borrows the scene's bytes
/// (docs/format.md, "Inputs").
class GlyphSet {
public:
    GlyphSet() = default;
    /// Takes `bytes` as far as the set goes.
    static GlyphSet take(ByteReader& bytes);

    /// At most 255.
    std::uint32_t count() const { return count_; }
    /// Nothing if the character is not one of them.
    std::optional<std::uint8_t> glyph(char32_t character) const;
    /// `glyph` is less than count(), and the set is sound.
    char32_t character(std::uint32_t glyph) const;
    /// Whether it is what the format allows: characters rise with their numbers.
    bool is_valid() const;

private:
    /// Characters that follow each other, as far as the next stretch.
    struct Stretch {
        std::uint32_t glyph; ///< of the first
        char32_t character;  ///< the first
    };

    std::uint32_t stretches() const { return static_cast<std::uint32_t>(stretches_.size() / 4); }
    Stretch stretch(std::uint32_t number) const;
    /// The number of the glyph behind those of a stretch.
    std::uint32_t end_of(std::uint32_t number) const;

    std::uint32_t count_ = 0;
    std::span<const std::byte> stretches_;
};

}
