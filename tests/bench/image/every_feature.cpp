#include "tests/bench/image/measured_scene.hpp"

namespace kfast::bench {

const Features& linked_features = every_feature;

}
