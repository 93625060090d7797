#include "host/beam/blur.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace kfast {
namespace {

constexpr double kernel_reach = 3.2; // in standard deviations; beyond lies a thousandth

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

}

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

void blur(std::span<float> plane, Size size, std::span<const float> half_kernel)
{
    std::vector<float> before;
    for (int y = 0; y < size.height; ++y)
        blur_row(row_of(plane, size, y), half_kernel, before);
    blur_columns(plane, size, half_kernel);
}

void blur_by_box(std::span<float> plane, Size size, int reach)
{
    std::vector<float> before;
    for (int y = 0; y < size.height; ++y)
        box_row(row_of(plane, size, y), reach, before);
    box_columns(plane, size, reach);
}

}
