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

/// The time from which on an entry of a list is present, or absent.
struct Switching {
    double time = 0; ///< seconds
    bool on = true;
};

struct Entry {
    ValueNodePtr value;
    std::vector<Switching> switchings; ///< in the order of their times; none: always present
};

/// A formula of the file: a constant, an animation, or something composed of others.
struct ValueNode {
    std::string kind;      ///< the name of its element; "constant" for those of plain types
    std::string type;      ///< of its value: "real", "vector" ...
    std::size_t place = 0; ///< offset into the text of the file
    Value constant;
    std::vector<std::pair<std::string, ValueNodePtr>> links;
    std::vector<Waypoint> waypoints; ///< of "animated", in the order of their times
    std::vector<Entry> entries;      ///< of lists
    bool loop = false;
    /// Kinds that cannot be evaluated, or not as Synfig does, in itself and in all that it is composed of
    /// except bones: a few of them.
    std::set<std::string> unknown;
    int depth = 0; ///< nesting depth of the nodes below it, itself not counted

    /// Null if there is no such link.
    const ValueNode* link(std::string_view name) const
    {
        for (const auto& [own, node] : links)
            if (own == name)
                return node.get();
        return nullptr;
    }
};

/// How far an entry of a list is present.
struct Presence {
    double amount = 1;  ///< 0 to 1
    double on_time = 0; ///< in between: when it is fully present, and when absent; in seconds
    double off_time = 0;
};

Presence presence_at(const Entry& entry, double time);

/// Whether values of that type change smoothly between waypoints; others jump.
bool goes_smoothly(const Value& value);

/// The value between one waypoint and the next, both of them constants: `time` is between theirs. Between
/// waypoints values follow cubic Hermite curves; the tangents at a waypoint follow from its interpolations,
/// its neighbours and how far away they are.
Value value_on_way(const std::vector<Waypoint>& waypoints, std::size_t index, double time);

/// The progress for a fraction of the time, by the temporal tensions of both waypoints.
double warped_share(const Waypoint& from, const Waypoint& to, double share);

}
