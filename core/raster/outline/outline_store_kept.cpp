// What an OutlineStore keeps from one picture to the next, and takes in before it is placed.

#include "core/bytes/op_counter.hpp"
#include "core/raster/outline/outline_store.hpp"
#include "core/raster/outline/simplify.hpp"

#include <algorithm>

namespace kfast::raster {

void OutlineStore::keep(const Dependence& moved)
{
    if (is_full_)
        return clear(); // some layers are not complete
    std::byte* kept_end = bytes_ + size_;
    each_layer([&](LayerOutlines& layer) {
        if (layer.step == LayerOutlines::no_step || layer.dependence.is_touched_by(moved))
            return;
        layer.step = LayerOutlines::no_step;
        const std::byte* const begin = reinterpret_cast<std::byte*>(&layer) - layer.bytes;
        const std::byte* const end = begin + bytes_of(layer);
        kept_end = kept_end == end ? kept_end - (end - begin) : std::copy_backward(begin, end, kept_end);
    });
    chains_ = kept_end;
    begin_picture();
}

/// Looks among those that were traced after the one that was reused last. Null if it is not among the next.
LayerOutlines* OutlineStore::kept_layer(LayerName name) const
{
    std::byte* end = kept_;
    for (int passed = 0; end != kept_end_ && passed != look_ahead; ++passed) {
        LayerOutlines& layer = layer_below(end);
        if (layer.has_name(name))
            return &layer;
        end -= bytes_of(layer);
    }
    return nullptr;
}

const LayerOutlines* OutlineStore::reuse(LayerName name, std::uint16_t step)
{
    LayerOutlines* const layer = kept_layer(name);
    if (layer == nullptr)
        return nullptr;
    const auto taken = static_cast<std::size_t>(bytes_ + size_ - chains_) - waiting_;
    needed_ = std::max(needed_, std::size_t{taken + sizeof(LayerOutlines) + layer->peak_bytes});
    is_full_ = is_full_ || needed_ > size_;
    waiting_ -= bytes_of(*layer);
    kept_ = reinterpret_cast<std::byte*>(layer + 1) - bytes_of(*layer);
    layer->step = step;
    each_chain_of(*layer, [&](Chain& chain) {
        count_op(Op::kept_chain);
        chain.layer = step;
        rewind(chain);
    });
    return layer;
}

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

/// Places all corners of the incoming contour.
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
