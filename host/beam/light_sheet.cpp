#include "host/beam/light_sheet.hpp"

#include "core/math/point.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <span>
#include <vector>

namespace kfast {

namespace {

constexpr double kernel_reach = 3.2; // in standard deviations; a thousandth is beyond

/// to[i] += factor * from[i + offset], where there is one.
void add_shifted(std::span<float> to, std::span<const float> from, int offset, float factor)
{
    const int count = static_cast<int>(to.size());
    const int begin = std::max(0, -offset);
    const int end = std::min(count, count - offset);
    float* const target = to.data();
    const float* const source = from.data();
    for (int i = begin; i < end; ++i)
        target[i] += factor * source[i + offset];
}

void blur_row(std::span<float> row, std::span<const float> half_kernel, std::vector<float>& before)
{
    before.assign(row.begin(), row.end());
    std::ranges::fill(row, 0.0F);
    const int reach = static_cast<int>(half_kernel.size()) - 1;
    for (int offset = -reach; offset <= reach; ++offset)
        add_shifted(row, before, offset, half_kernel[static_cast<std::size_t>(std::abs(offset))]);
}

/// A plane's columns are rows of whole rows.
void blur_columns(std::span<float> plane, Size size, std::span<const float> half_kernel)
{
    const std::vector<float> before(plane.begin(), plane.end());
    std::ranges::fill(plane, 0.0F);
    const int reach = static_cast<int>(half_kernel.size()) - 1;
    for (int offset = -reach; offset <= reach; ++offset)
        add_shifted(plane, before, offset * size.width,
                    half_kernel[static_cast<std::size_t>(std::abs(offset))]);
}

std::span<float> row_of(std::span<float> plane, Size size, int y)
{
    const auto width = static_cast<std::size_t>(size.width);
    return plane.subspan(width * static_cast<std::size_t>(y), width);
}

void box_row(std::span<float> row, int reach, std::vector<float>& before)
{
    before.assign(row.begin(), row.end());
    const int count = static_cast<int>(row.size());
    const double share = 1.0 / (2 * reach + 1);
    double sum = 0;
    for (int i = -reach; i < count; ++i) {
        if (i + reach < count)
            sum += double{before[static_cast<std::size_t>(i + reach)]};
        if (i - reach - 1 >= 0)
            sum -= double{before[static_cast<std::size_t>(i - reach - 1)]};
        if (i >= 0)
            row[static_cast<std::size_t>(i)] = static_cast<float>(std::max(0.0, sum) * share);
    }
}

void box_columns(std::span<float> plane, Size size, int reach)
{
    std::vector<float> before(plane.begin(), plane.end());
    std::vector<double> sums(static_cast<std::size_t>(size.width));
    const auto add = [&](int y, double sign) {
        if (y < 0 || y >= size.height)
            return;
        const std::span<float> row = row_of(before, size, y);
        for (std::size_t x = 0; x < sums.size(); ++x)
            sums[x] += sign * double{row[x]};
    };
    const double share = 1.0 / (2 * reach + 1);
    for (int y = -reach; y < size.height; ++y) {
        add(y + reach, 1);
        add(y - reach - 1, -1);
        if (y >= 0)
            std::ranges::transform(sums, row_of(plane, size, y).begin(), [share](double sum) {
                return static_cast<float>(std::max(0.0, sum) * share);
            });
    }
}

/// One half of a Gaussian with that standard deviation in pixels, from its middle outwards. The whole of it
/// sums up to 1.
std::vector<float> gaussian(double deviation)
{
    const int reach = static_cast<int>(std::ceil(kernel_reach * deviation));
    std::vector<double> half;
    double sum = 0;
    for (int i = 0; i <= reach; ++i) {
        half.push_back(std::exp(-0.5 * i * i / (deviation * deviation)));
        sum += (i == 0 ? 1 : 2) * half.back();
    }
    std::vector<float> kernel;
    std::ranges::transform(half, std::back_inserter(kernel),
                           [sum](double value) { return static_cast<float>(value / sum); });
    return kernel;
}

/// Spreads each value of a plane, row by row, by the kernel in both directions. Light beyond the edges
/// is lost.
void blur(std::span<float> plane, Size size, std::span<const float> half_kernel)
{
    std::vector<float> before;
    for (int y = 0; y < size.height; ++y)
        blur_row(row_of(plane, size, y), half_kernel, before);
    blur_columns(plane, size, half_kernel);
}

/// The same with a square of 2 * `reach` + 1 pixels a side, in a time that does not depend on it. Three times
/// in a row it is much like a Gaussian.
void blur_by_box(std::span<float> plane, Size size, int reach)
{
    std::vector<float> before;
    for (int y = 0; y < size.height; ++y)
        box_row(row_of(plane, size, y), reach, before);
    box_columns(plane, size, reach);
}

constexpr double longest_gap = 0.5;  // pixels between the points that represent a line
constexpr float halo_share = 0.07F;  // of the light: what glass and eye scatter
constexpr double halo_deviation = 5; // in widths of the spot
constexpr int halo_passes = 3;

/// Three boxes of that reach are as wide as a Gaussian: each has a variance of ((2 r + 1)^2 - 1) / 12.
int box_reach(double deviation)
{
    return std::max(1, static_cast<int>(std::lround((std::sqrt(4 * deviation * deviation + 1) - 1) / 2)));
}

}

LightSheet::LightSheet(Size size, int channels)
    : size_{size},
      channels_{channels},
      pixels_{static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)},
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

/// Divided among the four pixels around it, so that the centre of the light is where it fell.
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
