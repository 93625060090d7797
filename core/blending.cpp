#include "core/blending.hpp"

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

bool has_several_layers(const ItemView& item)
{
    return item.kind != ItemKind::object || layer_count(item.object.style) > 1;
}

bool may_be_blended(const ItemView& item) { return has_several_layers(item) && may_be_transparent(item); }

}
