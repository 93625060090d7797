#pragma once

#include "host/art/animation/animated.hpp"
#include "host/art/budget.hpp"

#include <cstddef>
#include <vector>

namespace kfast::svg {

/// When something is as it is, and how it goes on from there.
struct Instant {
    double time = 0;
    art::Ease ease = {};
};

/// A value at each of the instants, of which there is at least one, as keys: of equal ones in a row, only the
/// first and the last are needed, and of a value that never changes, one. `same` tells which are equal.
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

}
