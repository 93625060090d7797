#pragma once

#include "core/features.hpp"

namespace kfast::test {

/// The features of a program for which keep(feature) is true.
template <class Keep>
Features features_where(Keep keep)
{
    Features features = every_feature;
    const auto look_at = [&keep](Feature feature, auto& code) {
        if (!keep(feature))
            code = nullptr;
    };
    look_at(Feature::strokes, features.strokes);
    look_at(Feature::tweens, features.tweens);
    look_at(Feature::bones, features.bones);
    look_at(Feature::backbones, features.backbones);
    look_at(Feature::depth, features.depth);
    look_at(Feature::wires, features.wires);
    look_at(Feature::paths, features.paths);
    look_at(Feature::smooth, features.smooth);
    look_at(Feature::texts, features.texts);
    look_at(Feature::drawings, features.drawings);
    look_at(Feature::trims, features.trims);
    look_at(Feature::springs, features.springs);
    return features;
}

}
