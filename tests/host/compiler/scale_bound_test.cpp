#include "host/compiler/scale_bound.hpp"

#include "core/scene_view.hpp"
#include "host/compiler/enlargement.hpp"
#include "host/compiler/track_peak.hpp"
#include "tests/host/compiler/scene_parts.hpp"

#include <doctest/doctest.h>
#include <random>

namespace kfast::test {
namespace {

constexpr VelocityLaw swinging = VelocityLaw::bezier(0, -4096, 8192, 8192 + 4096); // d = 1/2 beyond both ends

scene::Track moving(Property property, std::int32_t from, std::int32_t to, LawPair laws = {})
{
    return {property,
            {{.time = {}, .laws = laws, .value = from}, {.time = Time::frame(9), .laws = {}, .value = to}}};
}

/// In the way from key i on, by the basis of Hermite.
double smooth_value(const std::vector<scene::TrackKey>& keys, std::size_t i, double u)
{
    const auto slope = [&keys](std::size_t at) {
        if (at == 0 || at + 1 == keys.size())
            return 0.0;
        return 1.0 * (keys[at + 1].value - keys[at - 1].value) /
               (keys[at + 1].time.ticks - keys[at - 1].time.ticks);
    };
    const double duration = keys[i + 1].time.ticks - keys[i].time.ticks;
    return (1 + 2 * u) * (1 - u) * (1 - u) * keys[i].value + u * u * (3 - 2 * u) * keys[i + 1].value +
           duration * u * (1 - u) * ((1 - u) * slope(i) - u * slope(i + 1));
}

scene::Track scaled(Property property, double factor)
{
    return fixed(property, static_cast<std::int32_t>(factor * 4096));
}

scene::Item grown(double factor, std::vector<scene::Item> items)
{
    return item(scene::Group{std::move(items)},
                {scaled(Property::scale_x, factor), scaled(Property::scale_y, factor)});
}

scene::Item use_of(std::size_t symbol, double factor)
{
    return item(scene::Use{symbol}, {scaled(Property::scale_x, factor), scaled(Property::scale_y, factor)});
}

}

TEST_CASE("the peak of a track counts keys on both sides of 0, and laws that lead beyond them")
{
    CHECK(track_peak(fixed(Property::x, -7)) == 7);
    CHECK(track_peak(moving(Property::x, 3, -9)) == 9);
    CHECK(track_peak(moving(Property::x, 100, 200, {swinging, {}})) == doctest::Approx(237.5));
    CHECK(track_peak(moving(Property::x, 100, 0, {swinging, {}})) == doctest::Approx(137.5));
    CHECK(track_peak(moving(Property::x, 0, 100, {{}, swinging})) == 100); // the law for y
    CHECK(track_peak(moving(Property::y, 0, 100, {{}, swinging})) == doctest::Approx(137.5));
    CHECK(track_peak(moving(Property::width, 0, 100, {swinging, {}})) == doctest::Approx(137.5));
}

TEST_CASE("the range of a smooth track counts where its curve leads beyond the keys")
{
    const auto range = [](std::initializer_list<std::int32_t> values) {
        scene::Track track{Property::x, {}, true};
        for (const std::int32_t value : values)
            track.keys.push_back(
                {.time = Time::frame(static_cast<int>(track.keys.size()) * 10), .laws = {}, .value = value});
        const auto [least, most] = track_range(track);
        return std::pair{least, most};
    };
    CHECK(range({-3}) == std::pair{-3.0, -3.0});
    CHECK(range({4, 4}) == std::pair{4.0, 4.0});
    CHECK(range({0, 90}) == std::pair{0.0, 90.0});
    CHECK(range({0, 45, 90}) == std::pair{0.0, 90.0});
    // The slope at the second key is 45 a way: at most there is 4/27 of that.
    CHECK(range({0, 90, 90}).second == doctest::Approx(90 + 45 * 4 / 27.0));
    CHECK(range({90, 0, 0}).first == doctest::Approx(-45 * 4 / 27.0));
    CHECK(range({0, 90, 90, 0}).second == doctest::Approx(90 + 45 / 4.0));
}

TEST_CASE("the range of a smooth track is as wide as its curve, and no wider")
{
    std::mt19937 random{5};
    for (int round = 0; round < 200; ++round) {
        scene::Track track{Property::x, {}, true};
        std::int32_t time = 0;
        for (int left = 5; left > 0; --left) {
            time += 1 + static_cast<std::int32_t>(random() % 5000);
            track.keys.push_back(
                {.time = {time}, .laws = {}, .value = static_cast<std::int32_t>(random() % 2000) - 1000});
        }
        double least = track.keys[0].value;
        double most = least;
        for (std::size_t i = 0; i + 1 < track.keys.size(); ++i)
            for (int step = 0; step <= 1000; ++step) {
                const double value = smooth_value(track.keys, i, step / 1000.0);
                least = std::min(least, value);
                most = std::max(most, value);
            }
        CHECK(track_range(track).least == doctest::Approx(least).epsilon(1e-4));
        CHECK(track_range(track).most == doctest::Approx(most).epsilon(1e-4));
    }
}

TEST_CASE("the larger scale of both axes counts, and 1 for the axis that has none")
{
    CHECK(scale_bound({}) == 1);
    CHECK(scale_bound({scaled(Property::scale_x, 0.5)}) == 1);
    CHECK(scale_bound({scaled(Property::scale_x, 0.5), scaled(Property::scale_y, -0.25)}) == 0.5);
    CHECK(scale_bound({scaled(Property::scale_x, 0.5), scaled(Property::scale_y, -3)}) == 3);
    CHECK(scale_bound({moving(Property::scale_y, 4096, 8192, {{}, swinging})}) == doctest::Approx(2.375));
    CHECK(scale_bound({moving(Property::scale_x, 4096, 8192, {{}, swinging})}) == 2);
}

TEST_CASE("a symbol is enlarged by the most of its uses, through groups and other symbols")
{
    const std::vector<scene::Symbol> symbols{{"leaf", {}},
                                             {"twig", {use_of(0, 3), use_of(0, 2)}},
                                             {"bush", {grown(5, {use_of(1, 1)})}},
                                             {"alone", {}}};
    const auto bounds = [&symbols](std::vector<scene::Item> items) {
        const scene::Scene scene = scene_of(std::move(items), symbols);
        const Extents extents{scene};
        std::vector<double> factors;
        for (const Enlargement& enlargement : symbol_enlargements(extents))
            factors.push_back(enlargement.factor());
        return factors;
    };
    CHECK(bounds({}) == std::vector<double>{0, 0, 0, 0});
    CHECK(bounds({use_of(1, 0.5)}) == std::vector<double>{1.5, 0.5, 0, 0});
    CHECK(bounds({use_of(2, 2)}) == std::vector<double>{30, 10, 2, 0});
    CHECK(bounds({use_of(2, 1), grown(4, {use_of(0, 16)})}) == std::vector<double>{64, 5, 1, 0});
}

TEST_CASE("pieces of curves and arcs grow with the square root of the scale")
{
    const auto pieces = [](double factor) {
        scene::Object object = stroked(64, {key(0, curve({0, 0}, {0, 4000}, {4000, 4000}, {4000, 0}))});
        object.stroke->cap = Cap::round;
        const std::vector<std::byte> bytes =
            written(scene_of({grown(factor, {item(object, {moving(Property::width, 16, 256)})})}));
        const ItemView group = SceneView::parse(bytes)->items().next();
        const ObjectView view = ItemCursor{group.items}.next().object;
        return std::pair{view.keys().next().curve_pieces, view.style.arc_pieces};
    };
    CHECK(pieces(1) == std::pair{93U, 19U});
    CHECK(pieces(4) == std::pair{185U, 37U});
    CHECK(pieces(0.25) == std::pair{47U, 10U});
    CHECK(pieces(0) == std::pair{1U, 4U});
    CHECK(pieces(64).second == 145U);
}

TEST_CASE("pieces stop where the format does")
{
    const scene::Object object = stroked(64, {key(0, curve({0, 0}, {0, 40}, {40, 40}, {40, 0}))});
    const std::vector<std::byte> bytes =
        written(scene_of({grown(64, {grown(64, {grown(64, {item(object)})})})}));
    ItemView inner = SceneView::parse(bytes)->items().next();
    while (inner.kind == ItemKind::group)
        inner = ItemCursor{inner.items}.next();
    CHECK(inner.object.keys().next().curve_pieces == 1024);
    CHECK(inner.object.style.arc_pieces == 1024);
}

}
