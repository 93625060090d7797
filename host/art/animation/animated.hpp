#pragma once

#include "host/art/animation/ease.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

namespace kfast::art {

constexpr double mixed(double from, double to, double share) { return from + share * (to - from); }

/// A value at a time; the ease governs the transition to the next key.
template <typename Value>
struct Key {
    double time = 0; ///< in frames of the document
    Value value = {};
    Ease ease = {};
    friend bool operator==(const Key&, const Key&) = default;
};

/// Something that changes over time. Has at least one key, and their times rise; holds its first value before
/// the first key and its last one after the last. Value has an overload of mixed(from, to, share).
template <typename Value>
struct Animated {
    std::vector<Key<Value>> keys;

    Animated() : keys(1) {}
    Animated(Value value) : keys{{0, std::move(value), {}}} {}
    explicit Animated(std::vector<Key<Value>> given) : keys{std::move(given)} {}

    bool is_still() const { return keys.size() == 1; }
    /// The value; only if is_still().
    const Value& value() const { return keys.front().value; }

    Value at(double time) const
    {
        const auto next = std::upper_bound(keys.begin(), keys.end(), time,
                                           [](double moment, const auto& key) { return moment < key.time; });
        if (next == keys.begin())
            return keys.front().value;
        const auto& key = *std::prev(next);
        if (next == keys.end())
            return key.value;
        return mixed(key.value, next->value,
                     share_of_way(key.ease, (time - key.time) / (next->time - key.time)));
    }

    friend bool operator==(const Animated&, const Animated&) = default;
};

/// A number over time.
using Channel = Animated<double>;

}
