#include "core/math/turning.hpp"

namespace kfast {
namespace {

/// A unit vector's component in Q30 times a scale in 1/2^20, as a Q16 factor.
std::int32_t scaled_component(std::int32_t component, std::int32_t scale)
{
    return multiply(component, scale, 34);
}

/// A unit vector's component in Q30, in Q16.
std::int32_t component(std::int32_t q30) { return (q30 + (1 << 13)) >> 14; }

/// Of two components of unit vectors.
std::int32_t product(std::int32_t a, std::int32_t b) { return multiply(a, b, 30); }

struct CosineSine {
    explicit CosineSine(FineAngle angle) : cosine{kfast::cosine(angle)}, sine{kfast::sine(angle)} {}

    std::int32_t cosine; ///< Q30
    std::int32_t sine;
};

}

Space upright(const Turning& turning)
{
    const CosineSine z{turning.z};
    return {.plane = {.xx = scaled_component(z.cosine, turning.scale_x),
                      .xy = scaled_component(-z.sine, turning.scale_y),
                      .yx = scaled_component(z.sine, turning.scale_x),
                      .yy = scaled_component(z.cosine, turning.scale_y)}};
}

Space tilted(const Turning& turning)
{
    const CosineSine x{turning.x};
    const CosineSine y{turning.y};
    const CosineSine z{turning.z};
    const auto [scale_x, scale_y] = std::pair{turning.scale_x, turning.scale_y};
    const std::int32_t deep_x = -product(y.sine, z.cosine); // where turns about z and y take x and y in z
    const std::int32_t deep_y = product(y.sine, z.sine);
    return {.plane = {.xx = scaled_component(product(y.cosine, z.cosine), scale_x),
                      .xy = scaled_component(-product(y.cosine, z.sine), scale_y),
                      .yx = scaled_component(product(x.cosine, z.sine) - product(x.sine, deep_x), scale_x),
                      .yy = scaled_component(product(x.cosine, z.cosine) - product(x.sine, deep_y), scale_y)},
            .xz = component(y.sine),
            .yz = component(-product(x.sine, y.cosine)),
            .zx = scaled_component(product(x.sine, z.sine) + product(x.cosine, deep_x), scale_x),
            .zy = scaled_component(product(x.sine, z.cosine) + product(x.cosine, deep_y), scale_y),
            .zz = component(product(x.cosine, y.cosine))};
}

}
