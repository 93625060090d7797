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

/// The straight pieces that stand for half a turn of a round cap or join of a stroke `width` sixteenths of a
/// pixel wide: as many as keep them within 1/32 px of the circle, at least 4. For panels larger than the
/// canvas the number stays, so that the memory bound does not depend on the panel.
int arc_pieces(int width);

}
