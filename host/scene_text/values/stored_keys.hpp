#pragma once

#include "host/art/animation/animated.hpp"
#include "host/art/animation/ease.hpp"
#include "host/art/document/document.hpp"
#include "host/scene_text/values/grid.hpp"

#include <algorithm>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace kfast::scene_text {

/// "constant", "hold", "ease-in" or "bezier(0.1,0,0.9,1)"; control points beyond the range of laws are
/// clamped.
std::string law_of(const art::Ease& ease);

/// A key as the scene stores it.
template <typename Value>
struct StoredKey {
    std::int32_t ticks = 0;
    Value value = {};
    std::string law = "constant"; ///< from this key to the next
};

/// Moves times apart that rounding has made equal, by a tick each, and lets them end with the scene.
void part_ticks(std::vector<std::int32_t>& ticks, std::int32_t length);

/// Throws Failure if there are more keys than an item has.
void check_count(std::size_t keys);

/// Throws Failure if a coordinate cannot be that many pixels beside another one, as copies are.
void check_step(double pixels);

/// The parts of an ease of which each is a law of scenes; mostly the ease itself.
std::vector<art::EasePart> law_parts(const art::Ease& ease);

/// Keys with eases that scenes have.
template <typename Value>
std::vector<art::Key<Value>> with_laws(const art::Animated<Value>& animated)
{
    using art::mixed;
    std::vector<art::Key<Value>> keys;
    for (auto key = animated.keys.begin(); key != animated.keys.end(); ++key) {
        const auto next = std::next(key);
        if (next == animated.keys.end()) {
            keys.push_back(*key);
            continue;
        }
        for (const art::EasePart& part : law_parts(key->ease))
            keys.push_back({art::mixed(key->time, next->time, part.from),
                            part.way_from == 0 ? key->value : mixed(key->value, next->value, part.way_from),
                            part.ease});
    }
    return keys;
}

/// Leaves out keys that change nothing: equal to those before and after them.
template <typename Value>
void drop_idle(std::vector<StoredKey<Value>>& keys)
{
    std::vector<StoredKey<Value>> kept;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const bool is_last = i + 1 == keys.size();
        const bool stays = kept.empty() || kept.back().value == keys[i].value;
        const bool goes_on = is_last || keys[i].value == keys[i + 1].value;
        if (!stays || !goes_on || (is_last && kept.empty()))
            kept.push_back(std::move(keys[i]));
    }
    keys = std::move(kept);
}

/// The keys of a scene that is `length` ticks long; at least one. `round` makes a value what is stored.
template <typename Value, typename Round>
auto stored_keys(const art::Animated<Value>& animated, std::int32_t length, Round&& round)
{
    using Stored = std::decay_t<decltype(round(animated.keys.front().value))>;
    const std::vector<art::Key<Value>> keys = with_laws(animated);
    std::vector<std::int32_t> ticks;
    ticks.reserve(keys.size());
    for (const art::Key<Value>& key : keys)
        ticks.push_back(on_grid(key.time, times));
    check_count(ticks.size());
    part_ticks(ticks, length);
    std::vector<StoredKey<Stored>> result;
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (ticks[i] >= 0)
            result.push_back({ticks[i], round(keys[i].value), law_of(keys[i].ease)});
    drop_idle(result);
    return result;
}

/// The keys of a number.
std::vector<StoredKey<std::int32_t>> stored_keys(const art::Channel& channel, std::int32_t length,
                                                 const Grid& grid);

/// In ticks; at least one.
std::int32_t length_of(const art::Symbol& symbol);

/// When a node is visible, in a scene that is `length` ticks long: begins at 0.
std::vector<StoredKey<bool>> visible_keys(const std::vector<art::Span>& shown, std::int32_t length);

}
