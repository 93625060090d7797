#include "host/compiler/depth_bound.hpp"

#include "host/compiler/enlargement.hpp"
#include "tests/host/compiler/scene_parts.hpp"

#include <cmath>
#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// Of 64 x 48 pixels, so that its diagonal is 80, seen from 400 px away.
scene::Scene far_scene(std::vector<scene::Item> items = {}, std::vector<scene::Symbol> symbols = {})
{
    scene::Scene scene = scene_of(std::move(items), std::move(symbols));
    scene.camera = 400;
    return scene;
}

double slant() { return std::sqrt(1 + 0.1 * 0.1); }

/// A line from (0, 0) to (30, 40) px: 50 px long.
scene::Object slope() { return filled({key(0, lines({{0, 0}, {480, 640}}))}); }

scene::Item group(std::vector<scene::Track> tracks, std::vector<scene::Item> items = {})
{
    return item(scene::Group{std::move(items)}, std::move(tracks));
}

double factor(std::vector<scene::Item> around)
{
    const scene::Scene scene = far_scene();
    const Extents extents{scene};
    Enlargement enlargement = Enlargement::outermost(extents);
    for (const scene::Item& item : around)
        enlargement = enlargement.inside(item);
    return enlargement.factor();
}

const scene::Track about_y = fixed(Property::rotation_y, 16384);

}

TEST_CASE("without z and turns in space nothing is nearer")
{
    CHECK(factor({group({}), item(slope(), {fixed(Property::rotation, 9), fixed(Property::x, 900)})}) == 1);
    CHECK(factor({group({fixed(Property::scale_x, 3 * 4096)}), item(slope())}) == 3);
}

TEST_CASE("z brings nearer what lies in an item, or takes it away")
{
    CHECK(factor({group({fixed(Property::z, 200 * 16)})}) == 2);
    CHECK(factor({group({fixed(Property::z, 100 * 16)}), item(slope(), {fixed(Property::z, 100 * 16)})}) ==
          2);
    CHECK(factor({group({fixed(Property::z, -400 * 16)})}) == 0.5);
    CHECK(factor({group({fixed(Property::z, 200 * 16), fixed(Property::scale_y, 3 * 4096)})}) == 6);
    CHECK(factor({group({fixed(Property::z, 399 * 16)})}) == 16);
    CHECK(factor({group({fixed(Property::z, 2000 * 16)})}) == 16);
}

TEST_CASE("what turns comes nearer by its distance from the pivot and the sine of its angle")
{
    const scene::Track pivot_x = fixed(Property::pivot_x, 240);
    const scene::Track upright = fixed(Property::rotation_x, -20'000);
    CHECK(factor({item(slope(), {about_y})}) == doctest::Approx(400 / 370.0 * slant()));
    CHECK(factor({item(slope(), {upright})}) == doctest::Approx(400 / 360.0 * slant()));
    CHECK(factor({item(slope(), {upright, about_y})}) == doctest::Approx(400 / 330.0 * slant()));
    CHECK(factor({item(slope(), {about_y, pivot_x})}) == doctest::Approx(400 / 385.0 * slant()));
    CHECK(factor({item(slope(), {fixed(Property::rotation_y, 65536 / 12)})}) ==
          doctest::Approx(400 / 385.0 * slant()).epsilon(1e-4));
    CHECK(factor({item(slope(), {about_y, fixed(Property::scale_x, 8192)})}) ==
          doctest::Approx(2 * 400 / 340.0 * slant()));
    CHECK(factor({item(slope(), {about_y, fixed(Property::rotation, 1)})}) ==
          doctest::Approx(400 / 350.0 * slant()));
    CHECK(factor({item(slope(), {fixed(Property::rotation_y, 0)})}) == 1);
}

TEST_CASE("groups and uses turn about as far as what lies in them")
{
    const double near = 400 / (400 - 30.0) * slant();
    CHECK(factor({group({about_y}, {item(slope())})}) == doctest::Approx(near));
    CHECK(factor({group({about_y}, {group({}, {item(slope())})})}) == doctest::Approx(near));
    CHECK(factor({group({about_y})}) == doctest::Approx(slant()));
    CHECK(factor({group({fixed(Property::rotation_x, 16384)}, {item(slope())})}) ==
          doctest::Approx(400 / (400 - 40.0) * slant()));
    const scene::Item moved = item(slope(), {fixed(Property::x, 320)});
    CHECK(factor({group({about_y}, {moved})}) == doctest::Approx(400 / (400 - 50.0) * slant()));
    const scene::Item large = item(slope(), {fixed(Property::scale_x, 8192)});
    CHECK(factor({group({about_y}, {large})}) == doctest::Approx(400 / (400 - 60.0) * slant()));
    const scene::Item turned = item(slope(), {fixed(Property::rotation, 5)});
    CHECK(factor({group({about_y}, {turned})}) == doctest::Approx(400 / (400 - 50.0) * slant()));
    const scene::Scene scene = far_scene({}, {{"leaf", {item(slope())}}});
    const Extents extents{scene};
    CHECK(Enlargement::outermost(extents).inside(item(scene::Use{0}, {about_y})).factor() ==
          doctest::Approx(near));
}

TEST_CASE("what follows a path lies about it")
{
    scene::Item follower = item(slope(), {fixed(Property::along, 0)});
    follower.path = scene::Path{.stroke = lines({{0, 0}, {1600, 0}}).strokes.front()};
    CHECK(factor({group({about_y}, {follower})}) == doctest::Approx(400 / (400 - 130.0) * slant()));
}

TEST_CASE("what bones or backbones carry turns about as far as the canvas is large")
{
    scene::Object carried = slope();
    carried.skin = scene::Skin{};
    CHECK(factor({item(carried, {about_y})}) == doctest::Approx(400 / (400 - 64.0) * slant()));
}

TEST_CASE("in what turns, z may lead either way")
{
    const scene::Item leading = item(slope(), {fixed(Property::z, -136 * 16)});
    CHECK(factor({group({about_y}, {leading}), leading}) == doctest::Approx(400 / (400 - 166.0) * slant()));
}

TEST_CASE("laws that lead beyond keys take points further from the pivot")
{
    constexpr VelocityLaw swinging = VelocityLaw::bezier(0, -4096, 8192, 8192 + 4096); // 3/8 beyond both ends
    const scene::Drawing line = lines({{0, 0}, {480, 640}});
    const scene::Object object = filled({key(0, line, {swinging, {}}), key(9, line)});
    CHECK(factor({item(object, {about_y})}) == doctest::Approx(400 / (400 - 30 * 1.375) * slant()));
}

TEST_CASE("a symbol is as near as the nearest of its uses")
{
    const auto use = [](std::vector<scene::Track> tracks) { return item(scene::Use{0}, std::move(tracks)); };
    const std::vector<scene::Symbol> symbols{{"leaf", {}}};
    const scene::Scene scene =
        far_scene({use({fixed(Property::z, -1600)}),
                   group({fixed(Property::z, 1600)}, {use({fixed(Property::z, 1600)})})},
                  symbols);
    const scene::Scene unused = far_scene({}, symbols);
    CHECK(symbol_enlargements(Extents{scene}).front().factor() == 2);
    CHECK(symbol_enlargements(Extents{unused}).front().factor() == 0);
}

}
