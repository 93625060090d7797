#include "core/scene_check.hpp"

#include "core/blending.hpp"
#include "core/evaluator/prepare.hpp"
#include "core/kfb_limits.hpp"

#include <algorithm>

/// What a scene takes to be played.
namespace kfast {

bool SceneCheck::count_records()
{
    Preparer preparer{scene_, {}};
    preparer.run();
    scene_.records_ = preparer.records();
    scene_.records_.spaces = spaces_;
    const SceneRecords& records = scene_.records_;
    return records.timelines < LiveTrack::no_timeline && records.tracks <= kfb::max_tracks &&
           records.nodes <= kfb::max_nodes;
}

bool SceneCheck::count_items(ItemCursor items, const Depth& depth)
{
    while (!items.at_end())
        if (++items_ > kfb::max_items || !count_item(items.next(), depth) ||
            scene_.paint_steps_ > kfb::max_paint_steps)
            return false;
    return true;
}

/// `depth` is that of what lies around it.
bool SceneCheck::count_item(const ItemView& item, Depth depth)
{
    if (may_be_blended(scene_, item)) {
        scene_.paint_steps_ += 2;
        scene_.blended_depth_ = std::max(scene_.blended_depth_, ++depth.blended);
    }
    if (item.is_placed())
        spaces_ = std::max(spaces_, ++depth.placed);
    if (item.is_leaf()) {
        scene_.paint_steps_ += layer_count(item.object.style);
        return true;
    }
    if (depth.all++ == kfb::max_depth)
        return false;
    return count_items(scene_.items_in(item), depth);
}

}
