#include "host/preview/controls/zoom_steps.hpp"

#include <algorithm>
#include <array>

namespace kfast {
namespace {

constexpr std::array zooms{1, 2, 3, 4, 5, 6, 8, 10, 12, 16, 20, 24, 32, 48, largest_zoom};

}

int next_larger_zoom(double scale)
{
    const auto* const next = std::ranges::upper_bound(zooms, scale);
    return next == zooms.end() ? zooms.back() : *next;
}

int next_smaller_zoom(double scale)
{
    const auto* const here = std::ranges::lower_bound(zooms, scale);
    return here == zooms.begin() ? zooms.front() : *(here - 1);
}

}
