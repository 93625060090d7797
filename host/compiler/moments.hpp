#pragma once

#include "core/time.hpp"

#include <vector>

namespace kfast {

/// When to look at what moves from `since` to `until`, in order: at both, at those of `key_times` that lie
/// between, or at some 100 if there are more, and in even steps of at most a frame between them, but no more
/// than 8 times between two keys where the whole time has more than 200 frames. `key_times` rise.
std::vector<Time> moments_between(Time since, Time until, const std::vector<Time>& key_times);

}
