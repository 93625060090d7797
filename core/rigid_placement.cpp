#include "core/rigid_placement.hpp"

#include <algorithm>
#include <cstdlib>

namespace kfast {
namespace {

constexpr int fraction_bits = raster::CornerMap::fraction_bits;
constexpr int inverse_bits = 36;
constexpr std::int32_t one = 1 << fraction_bits;

/// By what lengths may grow once more when corners are placed; above 1, so that what is only turned keeps its
/// scale although its factors are rounded.
constexpr std::int32_t most_growth = one * 17 / 16;
/// How far a map may be from a turn that grows, by part of its growth: pens become that much broader on a side.
constexpr std::int32_t tolerance = one / 128;

constexpr std::int64_t max_shift = std::int64_t{raster::CornerMap::max_shift} << (16 - raster::grid_bits);

bool is_within(std::int64_t value, std::int64_t limit) { return value >= -limit && value <= limit; }

}

RigidPlacements::RigidPlacements(std::int32_t canvas_scale)
    : base_{std::max<std::int32_t>(canvas_scale >> most_scale_bits, 1) << most_scale_bits},
      inverse_{(std::int64_t{1} << inverse_bits) / base_}
{
}

std::optional<RigidPlacement> RigidPlacements::of(const Affine& map) const
{
    // Less than 2^most_scale_bits, and a little; Q14.
    constexpr std::int64_t most_factor = std::int64_t{most_growth} << most_scale_bits;
    const auto factor = [this](std::int32_t q16) {
        constexpr int shift = inverse_bits - fraction_bits;
        return base_ == Fixed::one ? (q16 + 2) >> 2
                                   : (q16 * inverse_ + (std::int64_t{1} << (shift - 1))) >> shift;
    };
    const std::int64_t wide_xx = factor(map.xx);
    const std::int64_t wide_yx = factor(map.yx);
    const std::int64_t wide_xy = factor(map.xy);
    const std::int64_t wide_yy = factor(map.yy);
    if (!is_within(wide_xx, most_factor) || !is_within(wide_yx, most_factor) ||
        !is_within(wide_xy, most_factor) || !is_within(wide_yy, most_factor) ||
        !is_within(map.x0, max_shift) || !is_within(map.y0, max_shift))
        return std::nullopt;
    const auto xx = static_cast<std::int32_t>(wide_xx);
    const auto yx = static_cast<std::int32_t>(wide_yx);
    const auto xy = static_cast<std::int32_t>(wide_xy);
    const auto yy = static_cast<std::int32_t>(wide_yy);
    const std::int32_t shear =
        std::min(std::abs(xx - yy) + std::abs(xy + yx), std::abs(xx + yy) + std::abs(xy - yx));
    const std::int64_t square = std::int64_t{xx} * xx + std::int64_t{yx} * yx;
    int bits = -most_scale_bits;
    const auto limit = [](int scale_bits) {
        constexpr std::int64_t most = std::int64_t{most_growth} * most_growth;
        return scale_bits < 0 ? most >> -2 * scale_bits : most << 2 * scale_bits;
    };
    while (bits <= most_scale_bits && square > limit(bits))
        ++bits;
    if (bits > most_scale_bits || shear > (bits < 0 ? tolerance >> -bits : tolerance << bits))
        return std::nullopt;
    const auto scaled = [bits](std::int32_t value) {
        return bits < 0 ? value << -bits : bits == 0 ? value : (value + (1 << (bits - 1))) >> bits;
    };
    return RigidPlacement{.scale_bits = static_cast<std::int8_t>(bits),
                          .scale = bits < 0 ? base_ >> -bits : base_ << bits,
                          .map = {scaled(xx), scaled(xy), scaled(yx), scaled(yy),
                                  static_cast<std::int32_t>(map.x0), static_cast<std::int32_t>(map.y0)}};
}

}
