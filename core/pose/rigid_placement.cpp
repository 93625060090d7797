#include "core/pose/rigid_placement.hpp"

#include "core/math/fixed.hpp"

#include <algorithm>
#include <cstdlib>

namespace kfast {
namespace {

constexpr int fraction_bits = raster::CornerMap::fraction_bits;
constexpr int inverse_bits = 36;
constexpr std::int32_t one = 1 << fraction_bits;

/// By what lengths may grow once more when corners are placed; above 1, so that what is only turned keeps its
/// scale although its factors are rounded.
constexpr std::int32_t max_scale_factor = one * 17 / 16;
/// How far a map may be from a turn that grows, by part of its growth: pens become that much broader on a
/// side.
constexpr std::int32_t tolerance = one / 128;

constexpr std::int32_t max_factor = 1 << 20; ///< far more than the largest scale

constexpr std::int64_t max_shift = std::int64_t{raster::CornerMap::max_shift} << (16 - raster::grid_bits);

std::int64_t sum_of_squares(std::int32_t a, std::int32_t b)
{
    constexpr std::int32_t max = 1 << 15;
    if (std::abs(a) <= max && std::abs(b) < max) // mostly, in 32 bits
        return a * a + b * b;
    return std::int64_t{a} * a + std::int64_t{b} * b;
}

bool is_within(std::int64_t value, std::int64_t limit) { return value >= -limit && value <= limit; }

}

RigidPlacements::RigidPlacements(std::int32_t canvas_scale)
    : base_{std::max<std::int32_t>(canvas_scale >> max_scale_bits, 1) << max_scale_bits},
      inverse_{quotient(std::int64_t{1} << inverse_bits, static_cast<std::uint32_t>(base_))}
{
}

std::int32_t RigidPlacements::factor(std::int32_t q16) const
{
    if (base_ == Fixed::one) // mostly, and the same
        return std::clamp((q16 + 2) >> 2, -max_factor, max_factor);
    constexpr int shift = inverse_bits - fraction_bits;
    const std::int64_t wide = (q16 * inverse_ + (std::int64_t{1} << (shift - 1))) >> shift;
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(wide, -max_factor, max_factor));
}

std::optional<RigidPlacement> RigidPlacements::of(const Affine& map) const
{
    const std::int32_t xx = factor(map.xx);
    const std::int32_t xy = factor(map.xy);
    const std::int32_t yx = factor(map.yx);
    const std::int32_t yy = factor(map.yy);
    const std::int32_t shear =
        std::min(std::abs(xx - yy) + std::abs(xy + yx), std::abs(xx + yy) + std::abs(xy - yx));
    const std::int64_t square = sum_of_squares(xx, yx);
    int bits = -max_scale_bits;
    constexpr std::int64_t max = std::int64_t{max_scale_factor} * max_scale_factor;
    std::int64_t limit = max >> 2 * max_scale_bits;
    for (; bits <= max_scale_bits && square > limit; limit <<= 2)
        ++bits;
    const int up = bits + max_scale_bits; // from the smallest scale
    const std::int64_t scale = std::int64_t{base_ >> max_scale_bits} << up;
    if (bits > max_scale_bits || scale > Affine::steepest || shear > (tolerance << up) >> max_scale_bits ||
        !is_within(map.x0, max_shift) || !is_within(map.y0, max_shift))
        return std::nullopt;
    const auto scaled = [up](std::int32_t value) {
        return ((value << max_scale_bits) + ((1 << up) >> 1)) >> up;
    };
    return RigidPlacement{.scale_bits = static_cast<std::int8_t>(bits),
                          .scale = static_cast<std::int32_t>(scale),
                          .map = {scaled(xx), scaled(xy), scaled(yx), scaled(yy),
                                  static_cast<std::int32_t>(map.x0), static_cast<std::int32_t>(map.y0)}};
}

}
