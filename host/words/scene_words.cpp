#include "host/words/scene_words.hpp"

#include "host/text/number_text.hpp"
#include "host/words/law_words.hpp"
#include "host/words/spring_words.hpp"

#include <array>
#include <cstdio>

namespace kfast {

namespace {

/// In the order of Feature.
constexpr std::array<std::string_view, feature_count> names{"strokes", "tweens",   "bones", "backbones",
                                                            "depth",   "wires",    "paths", "smooth",
                                                            "texts",   "drawings", "trims", "springs"};

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

double written_amount(Property property, double stored)
{
    switch (property) {
    case Property::rotation_x:
    case Property::rotation_y:
    case Property::rotation:
        return stored * 360.0 / 65536;
    case Property::scale_x:
    case Property::scale_y:
        return stored / scale_one;
    case Property::along:
    case Property::trim_from:
    case Property::trim_to:
    case Property::trim_offset:
        return stored / path_whole;
    case Property::opacity:
        return stored / 255.0;
    case Property::order:
    case Property::visible:
    case Property::trim_mode:
    case Property::max_dashes:
        return stored;
    case Property::dash_offset:
    case Property::dash_1:
    case Property::gap_1:
    case Property::dash_2:
    case Property::gap_2:
    case Property::dash_3:
    case Property::gap_3:
        return stored / dash_pixel;
    default:
        return stored / 16.0;
    }
}

std::string colour_text(Colour colour)
{
    std::array<char, 10> text{};
    std::snprintf(text.data(), text.size(), colour.opacity == 255 ? "#%02x%02x%02x" : "#%02x%02x%02x%02x",
                  static_cast<unsigned>(colour.red), static_cast<unsigned>(colour.green),
                  static_cast<unsigned>(colour.blue), static_cast<unsigned>(colour.opacity));
    return text.data();
}

InputView input_of(const SceneView& scene, Driver driver)
{
    return scene.input(static_cast<std::uint32_t>(driver.index()));
}

double written_moment(const SceneView& scene, Driver driver, Time moment)
{
    if (!driver.is_input())
        return in_frames(moment);
    const InputView input = input_of(scene, driver);
    const double share = static_cast<double>(moment.ticks) / whole_input.ticks;
    return (input.min + share * (static_cast<double>(input.max) - input.min)) / 1000;
}

namespace {

std::string control_text(std::int16_t control)
{
    return rounded_text(static_cast<double>(control) / VelocityLaw::control_one);
}

}

std::string law_text(const VelocityLaw& law)
{
    if (is_spring(law))
        return spring_text(law);
    std::string keyword{word_of(law.kind).keyword};
    switch (law.kind) {
    case VelocityLaw::Kind::steps:
        return keyword + '(' + std::to_string(law.count) + ')';
    case VelocityLaw::Kind::bezier:
        return keyword + '(' + control_text(law.x1) + ',' + control_text(law.y1) + ',' +
               control_text(law.x2) + ',' + control_text(law.y2) + ')';
    default:
        return keyword;
    }
}

}
