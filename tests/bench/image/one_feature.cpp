#include "tests/bench/image/measured_scene.hpp"

// KFAST_FEATURES: the feature, from the build; none without it.
#ifndef KFAST_FEATURES
#define KFAST_FEATURES
#endif

namespace kfast::bench {

constexpr Features one_feature{KFAST_FEATURES};
const Features& linked_features = one_feature;

}
