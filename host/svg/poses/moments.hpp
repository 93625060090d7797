#pragma once

#include "host/art/animation/animated.hpp"
#include "host/art/budget.hpp"
#include "host/art/document/document.hpp"
#include "host/svg/parts/part.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace kfast::svg {

/// The time of a state of something, and how it changes from there on.
struct Instant {
    double time = 0;
    art::Ease ease = {};
};

/// A value at each of the instants, of which there is at least one, as keys: of equal ones in a row, only the
/// first and the last are needed, and of a value that never changes, one. `same` says which are equal.
template <typename Value, typename Same>
art::Animated<Value> keyed(const std::vector<Instant>& instants, const std::vector<Value>& values,
                           const Same& same, art::Budget& budget)
{
    std::vector<art::Key<Value>> keys;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const bool like_last = i > 0 && same(values[i], values[i - 1]);
        const bool like_next = i + 1 < values.size() && same(values[i], values[i + 1]);
        const bool is_last = i + 1 == values.size();
        if (!like_last || !(like_next || is_last))
            keys.push_back({instants[i].time, values[i], instants[i].ease});
    }
    budget.take_keys(keys.size());
    return art::Animated<Value>{std::move(keys)};
}

/// One part in one pose.
struct Moment {
    Instant instant;
    const Part* part = nullptr; ///< null: it is not there
    art::Affine fold;           ///< of what is around it: to pixels, or to the node around it
    std::size_t pose = 0;       ///< index
};

/// The same part in one pose after the other; there is at least one with it.
using Moments = std::vector<Moment>;

const Part& first_part(const Moments& moments);

/// The moments that have the part.
Moments present(const Moments& moments);

std::vector<Instant> instants(const Moments& moments);

/// A value of each of the moments.
template <typename Get>
auto values_of(const Moments& moments, const Get& get)
{
    std::vector<std::decay_t<decltype(get(*moments.front().part))>> values;
    for (const Moment& moment : moments)
        values.push_back(get(*moment.part));
    return values;
}

/// When the part is visible: from its moment on, until the next one without it.
std::vector<art::Span> spans(const Moments& moments);

/// From the part's own coordinates to those that its moment's fold leads to; any for what is not there.
std::vector<art::Affine> ways(const Moments& moments);

/// How a part moves from where it is at first.
struct Motion {
    art::Affine at_rest;                 ///< its map at one of the moments: goes into its points
    std::vector<art::Affine> from_there; ///< for each moment with it
    scene::Vec2 pivot;
};

/// Nothing if it stays, or if it has skew, so that no node can do the same.
std::optional<Motion> motion_of(const Moments& moments);

/// The same for something that is in a box at rest, by what maps it from there to each moment.
std::optional<Motion> motion_of(const art::Affine& at_rest, std::vector<art::Affine> from_there,
                                const Box& box);

/// The transform of a node, from the moments that have it. Rotations go the shorter way round.
art::Transform transform_of(const Motion& motion, const Moments& moments, art::Budget& budget);

}
