#include "core/raster/outline/simplify.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>

namespace kfast::raster {
namespace {

/// An edge replaces no more than these, so that each corner is looked at a few times at most.
constexpr std::ptrdiff_t max_replaced = 8;

/// Of an edge that replaces others, to either side: products have 32 bits.
constexpr std::int32_t max_extent = 256 * grid;

/// The length of a vector, at most 12 % too small or 4 % too large.
std::int32_t length(std::int32_t x, std::int32_t y)
{
    const std::int32_t a = std::abs(x);
    const std::int32_t b = std::abs(y);
    return std::max(a, b) + std::min(a, b) / 4;
}

/// Whether the corners between two others lie near the straight line from one to the other, and beside it.
bool are_near_line(const Corner* from, const Corner* to)
{
    const std::int32_t width = to->x - from->x;
    const std::int32_t height = to->y - from->y;
    if (std::abs(width) > max_extent || std::abs(height) > max_extent)
        return false;
    const std::int32_t square = width * width + height * height;
    const std::int32_t limit = simplify_tolerance * length(width, height);
    for (const Corner* corner = from + 1; corner != to; ++corner) {
        const std::int32_t x = corner->x - from->x;
        const std::int32_t y = corner->y - from->y;
        if (std::abs(x) > max_extent || std::abs(y) > max_extent)
            return false;
        const std::int32_t along = x * width + y * height;
        if (square == 0 && (x | y) != 0) // there and back
            return false;
        if (along < 0 || along > square || std::abs(x * height - y * width) > limit)
            return false;
    }
    return true;
}

}

Corner* simplify(Corner* first, Corner* end)
{
    Corner* out = first;
    for (const Corner* corner = first; end - corner > 1;) {
        const Corner* next = corner + 1;
        const Corner* const farthest = std::min<const Corner*>(end - 1, corner + max_replaced);
        while (next != farthest && are_near_line(corner, next + 1))
            ++next;
        corner = next;
        *++out = *next;
    }
    return first == end ? end : out + 1;
}

}
