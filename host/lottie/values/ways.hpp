#pragma once

#include "host/art/animation/animated.hpp"
#include "host/art/animation/ease.hpp"
#include "host/art/budget.hpp"
#include "host/lottie/values/channel.hpp"
#include "host/lottie/values/loops.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace kfast::lottie {

/// A key of a property as the file has it.
struct FileKey {
    double time = 0;             ///< in frames of the layer's composition
    const Json* key = nullptr;   ///< all of it
    const Json* begin = nullptr; ///< the value from here on
    const Json* end = nullptr;   ///< the value at the end of the transition, in old files; else null
    bool hold = false;
};

/// Of a property: an object with "k", or the value alone.
struct Property {
    const Json* value = nullptr; ///< if it is still; null if it is missing
    std::vector<FileKey> keys;   ///< if it is animated; their times do not fall
    std::optional<PropertyLoop> loop = {};
};

/// Throws WrongMember.
Property read_property(const Json& owner, const char* name);

/// A component of a value; a single number represents all of them.
double component(const Json& value, std::size_t index, double default_value);

/// The ease of component `index` in the transition that leaves the key: a hold, too. Where nothing changes,
/// programs write handles beyond all numbers; those are even there.
art::Ease read_ease(const FileKey& key, std::size_t index, bool changes);

/// The transition of a value from one time to another. The one before the first key and the one after the
/// last are endless.
template <typename Value>
struct Way {
    double from = 0;
    double to = 0;
    Value begin = {};
    Value end = {};
    art::Ease ease = {};
};

/// The transitions of a property between its keys; `value_of` makes a value of Json. At least one key.
template <typename Value, typename ValueOf>
std::vector<Way<Value>> read_ways(const std::vector<FileKey>& keys, std::size_t index, ValueOf value_of)
{
    constexpr double endless = std::numeric_limits<double>::infinity();
    const Value first = value_of(*keys.front().begin);
    std::vector<Way<Value>> ways{{-endless, keys.front().time, first, first}};
    Value begin = first;
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        Value next = value_of(*keys[i + 1].begin);
        if (keys[i + 1].time > keys[i].time) {
            const Value end = keys[i].hold ? begin : keys[i].end ? value_of(*keys[i].end) : next;
            const art::Ease ease = read_ease(keys[i], index, !(begin == end));
            ways.push_back({keys[i].time, keys[i + 1].time, begin, end, ease});
        }
        begin = std::move(next);
    }
    ways.push_back({keys.back().time, endless, begin, begin});
    return ways;
}

/// Converts them to frames of the scene, in their order there.
template <typename Value>
void place_in_scene(std::vector<Way<Value>>& ways, const LayerTime& time)
{
    for (Way<Value>& way : ways) {
        way.from = time.scene_frame(way.from);
        way.to = time.scene_frame(way.to);
    }
    if (time.stretch > 0)
        return;
    std::ranges::reverse(ways);
    for (Way<Value>& way : ways) {
        std::swap(way.from, way.to);
        std::swap(way.begin, way.end);
        way.ease = art::reversed(way.ease);
    }
}

/// The duration of a jump: the scene's resolution of time is 1/1024 frame.
inline constexpr double jump_time = 1.0 / 1024;

/// Where a transition does not begin at the value where the one before ended, the value jumps.
template <typename Value>
art::Animated<Value> joined(const std::vector<Way<Value>>& ways)
{
    std::vector<art::Key<Value>> keys;
    for (std::size_t i = 1; i < ways.size(); ++i) {
        const Way<Value>& before = ways[i - 1];
        const Way<Value>& way = ways[i];
        if (!(before.end == way.begin)) {
            const double moment = way.from - jump_time;
            if (keys.empty() || (!(before.begin == before.end) && moment > keys.back().time))
                keys.push_back({moment, before.end, {}});
            keys.back().ease = {.kind = art::EaseKind::hold};
        }
        if (keys.empty() || way.from > keys.back().time)
            keys.push_back({way.from, way.begin, way.ease});
    }
    return art::Animated<Value>{std::move(keys)};
}

/// `value_of` makes a value of Json. Nothing if the property is missing.
template <typename Value, typename ValueOf>
std::optional<art::Animated<Value>> read_animated(const Property& property, std::size_t index,
                                                  ValueOf value_of, const LayerTime& time,
                                                  art::Budget& budget)
{
    if (property.value)
        return art::Animated<Value>{value_of(*property.value)};
    if (property.keys.empty())
        return std::nullopt;
    budget.take_keys(property.keys.size());
    auto ways = read_ways<Value>(property.keys, index, value_of);
    place_in_scene(ways, time);
    if (property.loop)
        repeat_ways(ways, *property.loop, time, budget);
    return joined(ways);
}

}
