// What an OutlineStore takes in before it lies where it is seen.

#include "core/raster/outline_store.hpp"

#include "core/work.hpp"

namespace kfast::raster {

void OutlineStore::place_contours(const CornerMap* map, ContourCache* cache)
{
    map_ = map;
    cache_ = cache;
}

void OutlineStore::add(std::span<const ShortCorner> contour, const CornerMap& map)
{
    did(Work::placed_corner, static_cast<std::uint32_t>(contour.size()));
    if (contour.size() > static_cast<std::size_t>(behind_ - corners_end_))
        is_full_ = true;
    if (is_full_)
        return begin_contour();
    for (const ShortCorner corner : contour)
        *corners_end_++ = map(corner);
    add_contour();
}

/// All corners of the contour that is coming in.
void OutlineStore::place_corners()
{
    const std::span<Corner> corners{first_corner(), corners_end_};
    did(Work::placed_corner, static_cast<std::uint32_t>(corners.size()));
    if (cache_ != nullptr)
        cache_->add(corners);
    for (Corner& corner : corners)
        corner = (*map_)(corner);
}

}
