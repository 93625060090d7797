#pragma once

#include "core/features.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace kfast {

/// As docs/library.md, kfast.h and reports call it: "strokes".
std::string_view feature_name(Feature feature);

/// Of all of a set, in the order of Feature.
std::vector<std::string> feature_names(FeatureSet set);

/// "strokes, texts"; "no features".
std::string features_text(FeatureSet set);

/// Those of a set, in the order of Feature.
std::vector<Feature> features_in(FeatureSet set);

}
