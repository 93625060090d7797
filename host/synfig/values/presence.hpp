#pragma once

#include "host/synfig/values/value_node.hpp"

namespace kfast::synfig {

/// How far an entry of a list is there.
struct Presence {
    double amount = 1;  ///< 0 to 1
    double on_time = 0; ///< between the two: when it is all there, and when not at all; in seconds
    double off_time = 0;
};

Presence presence_at(const Entry& entry, double time);

}
