#pragma once

#include "core/math/point.hpp"

#include <algorithm>
#include <cstdint>

namespace kfast {

/// A map of the plane: x' = xx x + xy y + x0, y' = yx x + yy y + y0.
struct Affine {
    std::int32_t xx = Fixed::one; ///< Q16, as the other three; none is larger than `max_factor`
    std::int32_t xy = 0;
    std::int32_t yx = 0;
    std::int32_t yy = Fixed::one;
    std::int64_t x0 = 0; ///< in 1/65536 px: what covers a panel of another shape reaches far beyond Fixed
    std::int64_t y0 = 0;

    static constexpr std::int32_t max_factor = 1 << 28;

    /// Maps a point, rounded to 1/65536 px. x and y are clamped to ±16383 px, so that the differences of
    /// mapped coordinates fit in Fixed.
    Point operator()(Point point) const;
    /// The scale of lengths, in Q16: the square root of the scale of areas, rounded down.
    std::int32_t scale_factor() const;

    friend bool operator==(const Affine&, const Affine&) = default;
};

constexpr std::int32_t clamped_factor(std::int64_t value)
{
    return static_cast<std::int32_t>(
        std::clamp<std::int64_t>(value, -Affine::max_factor, Affine::max_factor));
}

/// First `inner`, then `outer`; rounded to the units of both. The shift of `inner` is within 65536 px.
/// Factors beyond Affine::max_factor are clamped to it.
Affine operator*(const Affine& outer, const Affine& inner);

/// Half the width of a stroke `width` wide, 0 or more, scaled by `scale_factor` (Q16); rounded to 1/65536 px,
/// at most 4095 px.
Fixed half_width(Fixed width, std::int32_t scale_factor);

/// How the canvas is fitted to a panel of another size; always centred.
enum class Fit : std::uint8_t {
    contain, ///< as large as fits as a whole, background around it
    cover,   ///< as small as fills the panel, the rest is cut off
    none,    ///< one canvas pixel is one panel pixel
};

/// From canvas to panel coordinates: one scale for both axes, rounded to 1/65536, then a shift. The sides are
/// 1 … 4096 pixels long.
Affine canvas_map(Size canvas, Size panel, Fit fit);

/// An Affine prepared for many points: the same bits in fewer steps. Most only shift, and few results are so
/// large that 64 bits are needed.
class PointMap {
public:
    /// `map` must outlive this.
    explicit PointMap(const Affine& map);

    Point operator()(Point point) const;

    /// Whether points, at least those within 1024 px, are only moved by shift().
    bool is_shift() const { return kind_ == Kind::shift; }
    Point shift() const;

private:
    enum class Kind : std::uint8_t { shift, small, any };

    const Affine& map_;
    Kind kind_;
};

}
