#include "core/stroke_style.hpp"

#include "core/square_root.hpp"

#include <algorithm>

namespace kfast {

// A chord over the angle a of a circle of radius r stays within r(1 - cos(a/2)), about r a^2 / 8. For 1/32 px
// that gives pi / a = 2 pi sqrt(r) pieces; r is width / 32 px. 72/64 is 2 pi / sqrt(32), rounded up.
int arc_pieces(int width)
{
    constexpr std::uint64_t scale = 72 * 72;
    const std::uint32_t pieces = (square_root(static_cast<std::uint64_t>(width) * scale) + 64) / 64;
    return std::max(4, static_cast<int>(pieces));
}

}
