#include "core/scene/glyph_set.hpp"

#include "core/bytes/code_point.hpp"

namespace kfast {

GlyphSet GlyphSet::take(ByteReader& bytes)
{
    GlyphSet set;
    set.count_ = bytes.u8();
    const std::size_t stretches = bytes.u8();
    set.stretches_ = bytes.take(4 * stretches).rest();
    return set;
}

std::optional<std::uint8_t> GlyphSet::glyph(char32_t character) const
{
    std::uint32_t low = 0; // what lies before it begins at `character` or before
    for (std::uint32_t high = stretches(); low < high;) {
        const std::uint32_t middle = (low + high) / 2;
        if (stretch(middle).character <= character)
            low = middle + 1;
        else
            high = middle;
    }
    if (low == 0)
        return std::nullopt;
    const Stretch found = stretch(low - 1);
    const std::uint32_t further = character - found.character;
    if (further >= end_of(low - 1) - found.glyph)
        return std::nullopt;
    return static_cast<std::uint8_t>(found.glyph + further);
}

char32_t GlyphSet::character(std::uint32_t glyph) const
{
    std::uint32_t number = 0;
    while (end_of(number) <= glyph)
        ++number;
    const Stretch found = stretch(number);
    return found.character + (glyph - found.glyph);
}

bool GlyphSet::is_valid() const
{
    if (stretches() == 0 || stretch(0).glyph != 0)
        return false;
    for (std::uint32_t number = 0; number < stretches(); ++number) {
        const Stretch here = stretch(number);
        const std::uint32_t end = end_of(number);
        if (end <= here.glyph)
            return false;
        const char32_t beyond = here.character + (end - here.glyph);
        const bool is_last = number + 1 == stretches();
        if (beyond > (is_last ? last_code_point + 1 : stretch(number + 1).character))
            return false;
    }
    return true;
}

GlyphSet::Stretch GlyphSet::stretch(std::uint32_t number) const
{
    const std::uint32_t both = ByteReader{stretches_.subspan(std::size_t{4} * number)}.u32();
    return {both & 0xFF, static_cast<char32_t>(both >> 8)};
}

std::uint32_t GlyphSet::end_of(std::uint32_t number) const
{
    return number + 1 < stretches() ? stretch(number + 1).glyph : count_;
}

}
