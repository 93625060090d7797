#include "host/compiler/scale_bound.hpp"

#include "core/scene_view.hpp"
#include "host/compiler/track_peak.hpp"
#include "tests/host/compiler/scene_parts.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

constexpr VelocityLaw swinging = VelocityLaw::bezier(0, -4096, 8192, 8192 + 4096); // d = 1/2 beyond both ends

scene::Track moving(Property property, std::int32_t from, std::int32_t to, LawPair laws = {})
{
    return {property,
            {{.time = {}, .laws = laws, .value = from}, {.time = Time::frame(9), .laws = {}, .value = to}}};
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
        return symbol_scale_bounds(scene_of(std::move(items), symbols));
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
