#include "host/art/animation/baked_drawing.hpp"
#include "host/art/geometry/affine.hpp"
#include "host/lottie/shapes/transform.hpp"

#include <cmath>

namespace kfast::lottie {
namespace {

using art::Affine;
using art::Channel;

/// Skew, then scale, then rotation.
struct SkewDecomposition {
    double rotation = 0;
    double scale_x = 1;
    double scale_y = 1;
    double skew = 0; ///< along the axis of x
};

/// The matrix as a rotation of a triangular one, by its first column.
SkewDecomposition decomposed(const Affine& matrix)
{
    const double width = std::sqrt(matrix.a * matrix.a + matrix.b * matrix.b);
    if (width == 0)
        return {0, 0, matrix.d, 0};
    const double cosine = matrix.a / width;
    const double sine = matrix.b / width;
    const double across = cosine * matrix.c + sine * matrix.d;
    return {std::atan2(sine, cosine) / art::degree, width, cosine * matrix.d - sine * matrix.c,
            -std::atan(across / width) / art::degree};
}

SkewDecomposition decomposed_at(const art::Transform& transform, double time)
{
    const Affine skewed = art::skewed(transform.skew.at(time), transform.skew_axis.at(time));
    return decomposed(skewed * art::grown(transform.scale_x.at(time), transform.scale_y.at(time)));
}

/// Critical are the times at which a transition of one begins or ends.
art::Baking baking_of(std::initializer_list<const Channel*> channels)
{
    art::Baking baking;
    baking.from = channels.begin()[0]->keys.front().time;
    baking.to = baking.from;
    for (const Channel* channel : channels)
        for (const auto& key : channel->keys) {
            baking.from = std::min(baking.from, key.time);
            baking.to = std::max(baking.to, key.time);
            baking.critical.push_back(key.time);
        }
    return baking;
}

Channel baked(const art::Transform& transform, double SkewDecomposition::*part, double tolerance)
{
    art::Baking baking =
        baking_of({&transform.scale_x, &transform.scale_y, &transform.skew, &transform.skew_axis});
    baking.tolerance = tolerance;
    return art::baked_channel([&](double time) { return decomposed_at(transform, time).*part; }, baking);
}

/// The sum of two numbers; where both change, accurate to a hundredth of a degree.
Channel sum(const Channel& one, const Channel& other)
{
    art::Baking baking = baking_of({&one, &other});
    baking.tolerance = 0.01;
    return art::baked_channel([&](double time) { return one.at(time) + other.at(time); }, baking);
}

Channel turned_by(const Channel& rotate, const Channel& rotation)
{
    const auto constant = steady_value(rotation);
    if (!constant)
        return sum(rotate, rotation);
    Channel result = rotate;
    for (auto& key : result.keys)
        key.value += *constant;
    return result;
}

}

void skew_before_scaling(art::Transform& transform)
{
    if (steady_value(transform.skew) == 0.0 || transform.scale_x == transform.scale_y)
        return;
    const art::Transform given = transform;
    constexpr double fine_degrees = 0.01;
    constexpr double fine_scale = 0.0001;
    transform.rotate = turned_by(given.rotate, baked(given, &SkewDecomposition::rotation, fine_degrees));
    transform.scale_x = baked(given, &SkewDecomposition::scale_x, fine_scale);
    transform.scale_y = baked(given, &SkewDecomposition::scale_y, fine_scale);
    transform.skew = baked(given, &SkewDecomposition::skew, fine_degrees);
    transform.skew_axis = Channel{0};
}

}
