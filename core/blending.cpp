#include "core/blending.hpp"

#include "core/kfb_limits.hpp"

namespace kfast {
namespace {

bool may_be_transparent(const ItemView& item)
{
    for (TrackCursor tracks = item.tracks; !tracks.at_end();) {
        const TrackView track = tracks.next();
        if (track.property == Property::opacity)
            return !track.is_fixed || track.value != 255;
    }
    return false;
}

}

bool has_several_layers(const SceneView& scene, const ItemView& item)
{
    ItemView only = item;
    for (std::uint32_t depth = 0; depth <= kfb::max_depth; ++depth) {
        if (only.is_leaf())
            return layer_count(only.object.style) > 1;
        ItemCursor items = scene.items_in(only);
        if (items.at_end())
            return false;
        only = items.next();
        if (!items.at_end())
            return true;
    }
    return true;
}

bool may_be_blended(const SceneView& scene, const ItemView& item)
{
    return may_be_transparent(item) && has_several_layers(scene, item);
}

}
