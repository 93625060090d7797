#include "host/words/feature_name.hpp"

#include <array>

namespace kfast {
namespace {

/// In the order of Feature.
constexpr std::array<std::string_view, feature_count> names{
    "strokes", "tweens", "bones", "backbones", "depth", "wires", "paths", "smooth", "texts", "drawings"};

}

std::string_view feature_name(Feature feature) { return names[static_cast<std::size_t>(feature)]; }

std::vector<std::string> feature_names(FeatureSet set)
{
    std::vector<std::string> found;
    for (const Feature feature : features_in(set))
        found.emplace_back(feature_name(feature));
    return found;
}

std::string features_text(FeatureSet set)
{
    std::string text;
    for (const std::string& name : feature_names(set))
        text += (text.empty() ? "" : ", ") + name;
    return text.empty() ? "no features" : text;
}

std::vector<Feature> features_in(FeatureSet set)
{
    std::vector<Feature> found;
    for (std::size_t number = 0; number < feature_count; ++number)
        if (set.has(static_cast<Feature>(number)))
            found.push_back(static_cast<Feature>(number));
    return found;
}

}
