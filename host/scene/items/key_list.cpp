#include "host/scene/items/key_list.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/items/key_reader.hpp"
#include "host/scene/values/key_driver.hpp"
#include "host/schema/property_rule.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace kfast::scene {

namespace {

/// Warns of each law and match that governs nothing: no later key sets what its key sets. `keys` are those of
/// one item.
void warn_of_idle_laws(std::span<const ItemKey> keys, SceneContext& context);

/// What keys set, a bit for each Property, and for drawings and skeletons one for each axis.
using Things = std::uint64_t;

constexpr Things bit(Property property) { return Things{1} << static_cast<unsigned>(property); }

constexpr Things drawing_x = Things{1} << property_count;
constexpr Things drawing_y = drawing_x << 1;
constexpr Things drawing = drawing_x | drawing_y;
constexpr Things skeleton_x = drawing_y << 1;
constexpr Things skeleton_y = skeleton_x << 1;
constexpr Things skeleton = skeleton_x | skeleton_y;
constexpr Things all_properties = drawing_x - 1;
constexpr Things of_x = bit(Property::x) | bit(Property::scale_x) | drawing_x | skeleton_x;
constexpr Things of_y = bit(Property::y) | bit(Property::scale_y) | drawing_y | skeleton_y;
constexpr Things without_way = bit(Property::order) | bit(Property::visible);

Things set_by(const ItemKey& key)
{
    Things things = (key.drawing ? drawing : 0) | (key.skeleton != nullptr ? skeleton : 0);
    for (std::size_t i = 0; i < property_count; ++i)
        if (key.values.get(static_cast<Property>(i)))
            things |= Things{1} << i;
    return things;
}

/// What is not governed by a law of its own axis.
Things governed_by_both(const ItemKey& key)
{
    const Things taken = (key.laws.x ? of_x : 0) | (key.laws.y ? of_y : 0);
    return ~taken & ~without_way;
}

void warn(const ItemKey& key, std::string_view property, SceneContext& context)
{
    context.report.warning(property_span(*key.node, property),
                           "this " + std::string{property} + " governs nothing",
                           "remove it, or let a later key set what this one sets");
}

/// `ways` are the things that a later key sets as well.
void warn_of_idle_laws(const ItemKey& key, Things ways, SceneContext& context)
{
    if (key.laws.both && (ways & governed_by_both(key)) == 0)
        warn(key, "law", context);
    if (key.laws.x && (ways & of_x) == 0)
        warn(key, "law-x", context);
    if (key.laws.y && (ways & of_y) == 0)
        warn(key, "law-y", context);
    if (key.match && (ways & drawing) == 0)
        warn(key, "match", context);
}

void warn_of_idle_laws(std::span<const ItemKey> keys, SceneContext& context)
{
    Things later = 0;
    for (std::size_t i = keys.size(); i-- > 0;) {
        // What the first key leaves out comes from its item.
        const Things own = set_by(keys[i]) | (i == 0 ? all_properties : 0);
        warn_of_idle_laws(keys[i], own & later, context);
        later |= own;
    }
}

}

bool KeyList::read(const kdl::Node& node)
{
    auto key = read_key(node, holder_, driver_, context_);
    if (!key || !in_order(*key))
        return false;
    keys_.push_back(std::move(*key));
    return true;
}

std::vector<ItemKey> KeyList::take()
{
    warn_of_idle_laws(keys_, context_);
    // The transition to a key is visible in part if it begins before the end.
    if (driver_.is_time())
        take_times(keys_, 1, key_name, context_);
    return std::move(keys_);
}

bool KeyList::in_order(const ItemKey& key)
{
    if (keys_.size() == max_keys)
        return context_.report.error(key.place, "at most " + std::to_string(max_keys) + " keys stand here");
    return keys_.empty() || comes_later(key_name, {keys_.back().time, keys_.back().place},
                                        {key.time, key.place}, driver_, context_);
}

}
