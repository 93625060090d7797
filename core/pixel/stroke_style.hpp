#pragma once

#include <cstdint>

namespace kfast {

/// How a stroke ends; the values are those of the scene format.
enum class Cap : std::uint8_t { butt, round, square };

/// How two segments of a stroke meet; the values are those of the scene format. A miter longer than its limit
/// becomes a bevel.
enum class Join : std::uint8_t { miter, round, bevel };

/// The longest miter, in 1/8 widths of the stroke: 4 widths, as in SVG.
inline constexpr int default_miter_limit = 4 * 8;

}
