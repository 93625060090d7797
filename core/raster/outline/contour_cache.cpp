#include "core/raster/outline/contour_cache.hpp"

#include <algorithm>
#include <new>

namespace kfast::raster {

static_assert(sizeof(ShortCorner) == 4 && alignof(ShortCorner) <= 4);

void ContourCache::add(std::span<const Corner> contour, std::size_t room)
{
    is_one_far_ = is_one_far_ || room > max_count || !std::ranges::all_of(contour, is_short);
    if (is_one_far_)
        return;
    std::uint32_t* out = cache_->add(1 + contour.size());
    if (out == nullptr)
        return;
    *out++ = static_cast<std::uint32_t>(room << count_bits | contour.size());
    for (const Corner& corner : contour)
        new (out++) ShortCorner{static_cast<std::int16_t>(corner.x), static_cast<std::int16_t>(corner.y)};
}

}
