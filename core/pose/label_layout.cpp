#include "core/pose/label_layout.hpp"

#include "core/scene/kfb_limits.hpp"

namespace kfast {
namespace {

constexpr std::int32_t sixteenth = kfb::advance_one / 16;

std::uint32_t number(std::byte glyph) { return std::to_integer<std::uint32_t>(glyph); }

}

LabelLayout::LabelLayout(const LabelView& label, std::span<const std::byte> glyphs)
    : label_{label}, rest_{glyphs}, x_{label.x * sixteenth}
{
    if (label.align == Align::left)
        return;
    std::int32_t width = 0;
    for (; !at_end(); rest_ = rest_.subspan(1))
        width += step();
    rest_ = glyphs;
    x_ -= label.align == Align::center ? width / 2 : width;
}

PlacedGlyph LabelLayout::next()
{
    const std::int32_t x = (x_ + sixteenth / 2) >> 8;
    static_assert(sixteenth == 1 << 8);
    const PlacedGlyph placed{static_cast<std::uint32_t>(label_.drawings[number(rest_[0])]),
                             {Fixed::sixteenths(x), Fixed::sixteenths(label_.y)}};
    x_ += step();
    rest_ = rest_.subspan(1);
    return placed;
}

/// From the first of the rest to where the next one begins, or to the end of the text.
std::int32_t LabelLayout::step() const
{
    const std::uint32_t glyph = number(rest_[0]);
    const std::int32_t advance = label_.advances[glyph];
    if (rest_.size() == 1)
        return advance;
    return advance + label_.spacing + label_.kerning_between(glyph, number(rest_[1]));
}

}
