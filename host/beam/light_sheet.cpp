#include "host/beam/light_sheet.hpp"

#include "host/beam/blur.hpp"

#include <algorithm>
#include <cmath>

namespace kfast {
namespace {

constexpr double longest_gap = 0.5;  // pixels between the points that stand for a line
constexpr float halo_share = 0.07F;  // of the light: what glass and eye scatter
constexpr double halo_deviation = 5; // as many times as wide as the spot
constexpr int halo_passes = 3;

/// Three boxes of that reach are as wide as a Gaussian: each has a variance of ((2 r + 1)^2 - 1) / 12.
int box_reach(double deviation)
{
    return std::max(1, static_cast<int>(std::lround((std::sqrt(4 * deviation * deviation + 1) - 1) / 2)));
}

}

LightSheet::LightSheet(Size size, int channels)
    : size_{size}, channels_{channels}, pixels_{static_cast<std::size_t>(size.width) *
                                                static_cast<std::size_t>(size.height)},
      planes_(pixels_ * static_cast<std::size_t>(channels))
{
}

void LightSheet::clear() { std::ranges::fill(planes_, 0.0F); }

std::span<float> LightSheet::plane(int channel)
{
    return {planes_.data() + pixels_ * static_cast<std::size_t>(channel), pixels_};
}

void LightSheet::add_line(BeamPlace from, BeamPlace to, const Light& light)
{
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    const int parts = std::max(1, static_cast<int>(std::ceil(length / longest_gap)));
    Light share = light;
    for (float& value : share)
        value /= static_cast<float>(parts);
    for (int i = 0; i < parts; ++i) {
        const double way = (i + 0.5) / parts;
        add({from.x + (to.x - from.x) * way, from.y + (to.y - from.y) * way}, share);
    }
}

/// Divided among the four pixels around it, so that the middle of the light is where it fell.
void LightSheet::add(BeamPlace at, const Light& light)
{
    const double left = std::floor(at.x);
    const double top = std::floor(at.y);
    if (left < -1 || top < -1 || left >= size_.width || top >= size_.height)
        return;
    const auto right_share = static_cast<float>(at.x - left);
    const auto low_share = static_cast<float>(at.y - top);
    const std::array<float, 4> shares{(1 - right_share) * (1 - low_share), right_share * (1 - low_share),
                                      (1 - right_share) * low_share, right_share * low_share};
    for (int corner = 0; corner < 4; ++corner) {
        const int x = static_cast<int>(left) + corner % 2;
        const int y = static_cast<int>(top) + corner / 2;
        if (x < 0 || y < 0 || x >= size_.width || y >= size_.height)
            continue;
        const auto index = static_cast<std::size_t>(y * size_.width + x);
        for (int channel = 0; channel < channels_; ++channel)
            planes_[pixels_ * static_cast<std::size_t>(channel) + index] +=
                light[static_cast<std::size_t>(channel)] * shares[static_cast<std::size_t>(corner)];
    }
}

void LightSheet::spread(double deviation)
{
    const std::vector<float> spot = gaussian(deviation);
    const int reach = box_reach(halo_deviation * deviation);
    for (int channel = 0; channel < channels_; ++channel) {
        const std::span<float> light = plane(channel);
        blur(light, size_, spot);
        std::vector<float> halo(light.begin(), light.end());
        for (int pass = 0; pass < halo_passes; ++pass)
            blur_by_box(halo, size_, reach);
        for (std::size_t i = 0; i < pixels_; ++i)
            light[i] += halo_share * (halo[i] - light[i]);
    }
}

Light LightSheet::at(std::size_t pixel) const
{
    Light light{};
    for (int channel = 0; channel < channels_; ++channel)
        light[static_cast<std::size_t>(channel)] =
            planes_[pixels_ * static_cast<std::size_t>(channel) + pixel];
    return light;
}

}
