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

/// How far an entry of a list is there.
struct Presence {
    double amount = 1;  ///< 0 to 1
    double on_time = 0; ///< between the two: when it is all there, and when not at all; in seconds
    double off_time = 0;
};

Presence presence_at(const Entry& entry, double time);

/// Whether values of that type go smoothly from waypoint to waypoint; others jump.
bool goes_smoothly(const Value& value);

/// On the way from one waypoint to the next, both of them constants: the share of the time is 0 to 1.
/// Between waypoints values go along cubic Hermite curves; the tangents at a waypoint follow from its
/// interpolations, its neighbours and how far away they are.
Value value_on_way(const std::vector<Waypoint>& waypoints, std::size_t index, double time);

/// The share of the way after that of the time, as the temporal tensions of both waypoints have it.
double warped_share(const Waypoint& from, const Waypoint& to, double share);

}
