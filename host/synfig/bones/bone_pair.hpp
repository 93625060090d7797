#pragma once

#include "host/synfig/values/value.hpp"

namespace kfast::synfig {

/// A bone at rest, and the one that it is posed as, at a moment.
struct BonePair {
    Bone rest;
    Bone pose;
};

}
