#include "core/math/projection.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <random>

namespace kfast::test {
namespace {

std::int32_t random_factor(std::mt19937& random)
{
    return std::uniform_int_distribution<std::int32_t>{-4 * Fixed::one, 4 * Fixed::one}(random);
}

std::int64_t random_shift(std::mt19937& random)
{
    return std::uniform_int_distribution<std::int64_t>{-(std::int64_t{500} << 16),
                                                       std::int64_t{500} << 16}(random);
}

Affine random_plane(std::mt19937& random)
{
    return {.xx = random_factor(random),
            .xy = random_factor(random),
            .yx = random_factor(random),
            .yy = random_factor(random),
            .x0 = random_shift(random),
            .y0 = random_shift(random)};
}

Space random_space(std::mt19937& random)
{
    return {.plane = random_plane(random),
            .xz = random_factor(random),
            .yz = random_factor(random),
            .zx = random_factor(random),
            .zy = random_factor(random),
            .zz = random_factor(random),
            .z0 = random_shift(random)};
}

struct Place {
    double x;
    double y;
    double z;
};

Place mapped(const Space& space, Place p)
{
    const Affine& plane = space.plane;
    const auto sum = [&p](std::int32_t x, std::int32_t y, std::int32_t z, std::int64_t shift) {
        return (x * p.x + y * p.y + z * p.z + static_cast<double>(shift)) / 65536;
    };
    return {sum(plane.xx, plane.xy, space.xz, plane.x0), sum(plane.yx, plane.yy, space.yz, plane.y0),
            sum(space.zx, space.zy, space.zz, space.z0)};
}

}

TEST_CASE("what was never turned in space is flat, and so is what was moved up and down again")
{
    CHECK(Space{}.is_flat());
    CHECK(Space{.plane = {.xx = 5, .xy = 6, .yx = 7, .yy = 8, .x0 = 9, .y0 = 10}}.is_flat());
    const Space nearer{.plane = {}, .z0 = 100};
    const Space farther{.plane = {}, .z0 = -100};
    CHECK_FALSE(nearer.is_flat());
    CHECK(product(nearer, farther, every_feature).is_flat());
    for (const auto part : {&Space::xz, &Space::yz, &Space::zx, &Space::zy}) {
        Space space;
        space.*part = 1;
        CHECK_FALSE(space.is_flat());
    }
}

TEST_CASE("flat spaces make the very product that their planes make, by the short way and by the long one")
{
    std::mt19937 random{98};
    for (int round = 0; round < 3000; ++round) {
        const Affine outer = random_plane(random);
        const Affine inner = random_plane(random);
        const Space flat =
            product({.plane = outer, .zz = 77}, {.plane = inner, .zz = 3 * Fixed::one}, Features{});
        CHECK(flat.plane == outer * inner);
        CHECK(flat.is_flat());
        CHECK(flat.zz == 231);
        const Space moved = product({.plane = outer}, {.plane = inner, .z0 = 1}, every_feature);
        CHECK(moved.plane == outer * inner);
    }
}

TEST_CASE("a product maps by the inner space first")
{
    std::mt19937 random{99};
    double worst = 0;
    for (int round = 0; round < 3000; ++round) {
        const Space outer = random_space(random);
        const Space inner = random_space(random);
        const auto coordinate = [&random] { return static_cast<double>(random() % 512) - 256; };
        const Place p{coordinate(), coordinate(), coordinate()};
        const Place exact = mapped(outer, mapped(inner, p));
        const Place is = mapped(product(outer, inner, every_feature), p);
        worst =
            std::max({worst, std::abs(is.x - exact.x), std::abs(is.y - exact.y), std::abs(is.z - exact.z)});
    }
    CHECK(worst < 3 * 256 * 0.51 / 65536 + 0.001);
}

TEST_CASE("factors of a product are held at the steepest")
{
    const Space steep{.plane = {.xx = Affine::max_factor, .yy = -Affine::max_factor},
                      .xz = Affine::max_factor,
                      .yz = -Affine::max_factor,
                      .zx = Affine::max_factor,
                      .zy = Affine::max_factor,
                      .zz = Affine::max_factor,
                      .z0 = std::int64_t{1} << 32};
    const Space steeper = product(steep, steep, every_feature);
    CHECK(steeper.plane.xx == Affine::max_factor);
    CHECK(steeper.plane.yx == -Affine::max_factor);
    CHECK(steeper.xz == Affine::max_factor);
    CHECK(steeper.zz == Affine::max_factor);
}

}
