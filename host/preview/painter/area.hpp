#pragma once

#include "core/math/point.hpp"

#include <algorithm>

namespace kfast {

constexpr bool is_empty(const Rect& area) { return area.width <= 0 || area.height <= 0; }

constexpr int right_of(const Rect& area) { return area.x + area.width; }
constexpr int bottom_of(const Rect& area) { return area.y + area.height; }

constexpr bool contains(const Rect& area, int x, int y)
{
    return x >= area.x && x < right_of(area) && y >= area.y && y < bottom_of(area);
}

/// What lies in both; of no size if nothing does.
constexpr Rect common(const Rect& a, const Rect& b)
{
    const int x = std::max(a.x, b.x);
    const int y = std::max(a.y, b.y);
    return {x, y, std::max(0, std::min(right_of(a), right_of(b)) - x),
            std::max(0, std::min(bottom_of(a), bottom_of(b)) - y)};
}

/// Without a margin on each side; of no size if nothing is left.
constexpr Rect inset(const Rect& area, int horizontal, int vertical)
{
    return {area.x + horizontal, area.y + vertical, std::max(0, area.width - 2 * horizontal),
            std::max(0, area.height - 2 * vertical)};
}
constexpr Rect inset(const Rect& area, int margin) { return inset(area, margin, margin); }

}
