#pragma once

#include "core/bytes/expects.hpp"
#include "core/math/angle.hpp"

#include <cstdint>

namespace kfast {

/// 8 bits per channel, as scenes store colours; an opacity of 255 is opaque.
struct Colour {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    std::uint8_t opacity = 255;
    friend constexpr bool operator==(Colour, Colour) = default;
};

/// `product` / 255, rounded to nearest, for a product of two values of 0 … 255. Without division, which costs
/// a Cortex-M0 a call; a test goes through all products.
constexpr std::uint32_t rounded_255th(std::uint32_t product)
{
    const std::uint32_t value = product + 128;
    return (value + (value >> 8)) >> 8;
}

/// A channel of 0 … 255 in a format whose largest value is `max`, at most 255; rounded to nearest.
constexpr std::uint32_t narrow_channel(std::uint32_t value, std::uint32_t max)
{
    return rounded_255th(value * max);
}

/// A channel of a pixel picture as 0 … 255, rounded to nearest.
constexpr std::uint32_t widen_channel(std::uint32_t value, std::uint32_t max)
{
    expects(max >= 1 && value <= max);
    return (value * 255 + max / 2) / max;
}

/// `over` blended over `under` with a coverage of 0 … 255, rounded to nearest; all in the same format.
constexpr std::uint32_t blend_channel(std::uint32_t under, std::uint32_t over, std::uint32_t coverage)
{
    expects(coverage <= 255);
    return rounded_255th(under * (255 - coverage) + over * coverage);
}

/// As blend_channel() for two channels, one in either half of the words.
constexpr std::uint32_t blend_two_channels(std::uint32_t under, std::uint32_t over, std::uint32_t coverage)
{
    constexpr std::uint32_t low_bytes = 0x00FF'00FF;
    const std::uint32_t value = under * (255 - coverage) + over * coverage + 0x0080'0080;
    return (value + (value >> 8 & low_bytes)) >> 8 & low_bytes;
}

/// Brightness, 0 … 255: 0.30 red + 0.59 green + 0.11 blue in 1/256, rounded to nearest.
constexpr std::uint32_t brightness(Colour colour)
{
    return (77U * colour.red + 150U * colour.green + 29U * colour.blue + 128) >> 8;
}

/// a b / 255, rounded to nearest; all are 0 … 255.
constexpr std::uint32_t product_of_opacities(std::uint32_t a, std::uint32_t b)
{
    return rounded_255th(a * b);
}

/// Which parts of the plane are inside of outlines that cross or enclose each other, as in SVG. The values
/// are those of the scene format.
enum class FillRule : std::uint8_t {
    nonzero,  ///< those that the outlines go around more often in one direction than in the other
    even_odd, ///< those that the outlines go around an odd number of times
};

/// Whether what the outlines go around `winding` times is inside.
constexpr bool is_inside(FillRule rule, std::int32_t winding)
{
    return rule == FillRule::nonzero ? winding != 0 : (winding & 1) != 0;
}

/// How a stroke ends; the values are those of the scene format.
enum class Cap : std::uint8_t { butt, round, square };

/// How two segments of a stroke meet; the values are those of the scene format. A miter longer than its limit
/// becomes a bevel.
enum class Join : std::uint8_t { miter, round, bevel };

/// The longest miter, in 1/8 widths of the stroke: 4 widths, as in SVG.
inline constexpr int default_miter_limit = 4 * 8;

/// What the beam of a vector display draws of an object.
enum class BeamParts : std::uint8_t {
    none,
    outline, ///< its strokes; of an object without strokes the border of its fill
    hatch,   ///< parallel lines across its fill
    both,
};

/// How beams draw an object; panels do not use it.
struct BeamStyle {
    BeamParts parts = BeamParts::outline;
    int spacing = 64;        ///< from a line of the hatching to the next, in 1/16 px
    BinaryAngle direction{}; ///< of these lines

    constexpr bool has_outline() const { return parts == BeamParts::outline || parts == BeamParts::both; }
    constexpr bool has_hatching() const { return parts == BeamParts::hatch || parts == BeamParts::both; }
    friend constexpr bool operator==(const BeamStyle&, const BeamStyle&) = default;
};

}
