// What an OutlineStore takes in before it lies where it is seen.

#include "core/raster/outline/outline_store.hpp"
#include "core/raster/outline/simplify.hpp"

#include "core/bytes/op_counter.hpp"

namespace kfast::raster {

void OutlineStore::place_contours(const CornerMap& map, const ContourName* name, ContourCache* cache)
{
    map_ = &map;
    cache_ = cache;
    is_named_ = name != nullptr;
    if (!is_named_ || layer_ == nullptr)
        return;
    name->add_to(layer_->fingerprint);
    map.add_to(layer_->fingerprint);
}

void OutlineStore::end_placed()
{
    map_ = nullptr;
    cache_ = nullptr;
    is_named_ = false;
}

void OutlineStore::add(const KeptContour& contour)
{
    count_op(Op::placed_corner, static_cast<std::uint32_t>(contour.corners.size()));
    if (!reserve(contour.room * sizeof(Corner)))
        return begin_contour();
    const CornerMap map = *map_;
    Corner* end = corners_end_;
    for (const ShortCorner& corner : contour.corners) // copies would be made by a function
        *end++ = map(corner);
    corners_end_ = end;
    add_contour();
}

/// All corners of the contour that is coming in.
void OutlineStore::place_corners()
{
    if (cache_ != nullptr) {
        const auto room = static_cast<std::size_t>(corners_end_ - first_corner());
        reserve(0);
        corners_end_ = simplify(first_corner(), corners_end_);
        cache_->add(std::span<const Corner>{first_corner(), corners_end_}, room);
    }
    count_op(Op::placed_corner, static_cast<std::uint32_t>(corners_end_ - first_corner()));
    for (Corner* corner = first_corner(); corner != corners_end_; ++corner)
        *corner = (*map_)(*corner);
}

}
