#pragma once

#include "host/synfig/values/value.hpp"

#include <cstddef>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kfast::synfig {

struct ValueNode;
using ValueNodePtr = std::shared_ptr<const ValueNode>;

/// How a value goes before or after a waypoint.
enum class Interpolation { automatic, constant, linear, halt, clamped };

struct Waypoint {
    double time = 0; ///< seconds
    ValueNodePtr value;
    Interpolation before = Interpolation::automatic;
    Interpolation after = Interpolation::automatic;
    double tension = 0;
    double continuity = 0;
    double bias = 0;
    double temporal_tension = 0;
};

/// From when on an entry of a list is there, or is not.
struct Switching {
    double time = 0; ///< seconds
    bool on = true;
};

struct Entry {
    ValueNodePtr value;
    std::vector<Switching> switchings; ///< in the order of their times; none: always there
};

/// A formula of the file: a constant, an animation, or something made of others.
struct ValueNode {
    std::string kind;      ///< the name of its element; "constant" for those of plain types
    std::string type;      ///< of its value: "real", "vector" ...
    std::size_t place = 0; ///< offset into the text of the file
    Value constant;
    std::vector<std::pair<std::string, ValueNodePtr>> links;
    std::vector<Waypoint> waypoints; ///< of "animated", in the order of their times
    std::vector<Entry> entries;      ///< of lists
    bool loop = false;
    /// Kinds that cannot be worked out, or not as Synfig does, of itself and of all that it is made of but
    /// bones: a few of them.
    std::set<std::string> unknown;
    int depth = 0; ///< nodes below each other that it is made of, itself not counted

    /// Nothing where there is no such link.
    const ValueNode* link(std::string_view name) const
    {
        for (const auto& [own, node] : links)
            if (own == name)
                return node.get();
        return nullptr;
    }
};

}
