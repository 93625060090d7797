#include "host/beam/phosphor.hpp"

#include "core/pixel/paint_style.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace kfast {
namespace {

constexpr double gamma = 2.2;       // of pictures on the PC
constexpr double sensitivity = 2.6; // light of 1 becomes 0.93 of white
constexpr float max_light = 5;      // from here on everything is white
constexpr int steps = 8192;         // of the square root of light, which is finer where it is dark
constexpr float spill = 0.05F;      // the fraction of other colours' light that a sensor takes for its own

/// Levels of one channel represent colours whose channels get lighter at different times: they can be
/// distinguished up to more light than one channel of rgb.
constexpr double level_sensitivity = 1;

struct Tint {
    double red, green, blue;
};

/// Chosen by the look of photographs.
constexpr Tint tint_of(Phosphor phosphor)
{
    switch (phosphor) {
    case Phosphor::green:
        return {0.13, 1, 0.35};
    case Phosphor::blue:
        return {0.16, 0.42, 1};
    case Phosphor::amber:
        return {1, 0.45, 0.05};
    case Phosphor::white:
    case Phosphor::rgb:
        return {0.86, 0.95, 1};
    }
    return {};
}

double exposed(double light, double sensitive = sensitivity) { return 1 - std::exp(-sensitive * light); }

std::uint8_t encoded(double share)
{
    return static_cast<std::uint8_t>(std::lround(255 * std::pow(std::clamp(share, 0.0, 1.0), 1 / gamma)));
}

double linear(std::uint8_t channel) { return std::pow(channel / 255.0, gamma); }

std::vector<std::uint8_t> level_table(double sensitive)
{
    std::vector<std::uint8_t> levels(steps + 1);
    for (int i = 0; i <= steps; ++i) {
        const double root = static_cast<double>(i) / steps;
        levels[static_cast<std::size_t>(i)] = encoded(exposed(root * root * double{max_light}, sensitive));
    }
    return levels;
}

std::vector<float> light_table()
{
    std::vector<float> light;
    for (int channel = 0; channel <= 255; ++channel)
        light.push_back(static_cast<float>(linear(static_cast<std::uint8_t>(channel))));
    return light;
}

/// The colour that is as light as each level.
std::vector<Colour> colour_table(const Tint& tint)
{
    constexpr int brightest = 255;
    std::vector<Colour> colours;
    for (int level = 0; level <= brightest; ++level) {
        const double share =
            std::min(linear(static_cast<std::uint8_t>(level)), exposed(double{max_light}, level_sensitivity));
        const double light = -std::log(1 - share) / level_sensitivity;
        colours.push_back({encoded(exposed(light * tint.red)), encoded(exposed(light * tint.green)),
                           encoded(exposed(light * tint.blue))});
    }
    return colours;
}

}

std::span<const PhosphorName> phosphor_names()
{
    static constexpr std::array<PhosphorName, 5> names{{
        {"green", Phosphor::green},
        {"blue", Phosphor::blue},
        {"amber", Phosphor::amber},
        {"white", Phosphor::white},
        {"rgb", Phosphor::rgb},
    }};
    return names;
}

Film::Film(Phosphor phosphor)
    : phosphor_{phosphor},
      light_{light_table()},
      levels_{level_table(channels() == 1 ? level_sensitivity : sensitivity)},
      colours_{colour_table(tint_of(phosphor))}
{
}

Light Film::light_of(Colour colour) const
{
    if (channels() == 1)
        return {light_[brightness(colour)]};
    return {light_[colour.red], light_[colour.green], light_[colour.blue]};
}

std::uint8_t Film::level(float light) const
{
    const float root = std::sqrt(std::min(light, max_light) / max_light);
    return levels_[static_cast<std::size_t>(root * steps + 0.5F)];
}

Colour Film::developed(const Light& light) const
{
    if (channels() == 1)
        return colours_[level(light[0])];
    const float spilt = spill * (light[0] + light[1] + light[2]);
    return {level(light[0] + spilt), level(light[1] + spilt), level(light[2] + spilt)};
}

}
