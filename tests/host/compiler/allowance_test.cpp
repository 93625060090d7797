#include "host/compiler/write_scene.hpp"

#include "tests/host/compiler/scene_parts.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// A drawing of `count` lines: `count` + 2 edges if it is filled, `count` + 1 points.
scene::Drawing many_lines(int count)
{
    scene::Stroke stroke;
    for (int i = 1; i <= count; ++i)
        stroke.segments.push_back(
            {.cubic = false, .c1 = {}, .c2 = {}, .to = {static_cast<std::int16_t>(i % 2), 0}});
    return {{stroke}};
}

scene::Item at(std::size_t place, scene::Item item)
{
    item.place = {place, 1};
    return item;
}

Diagnostic refusal(const scene::Scene& scene)
{
    Diagnostics diagnostics;
    REQUIRE(!write_scene(scene, diagnostics));
    REQUIRE(diagnostics.sorted().size() == 1);
    return diagnostics.sorted().front();
}

std::vector<scene::Item> uses(std::size_t count, std::size_t symbol)
{
    return std::vector<scene::Item>(count, item(scene::Use{symbol}));
}

}

TEST_CASE("too many edges are an error at the object with the most, with the figures")
{
    scene::Scene scene = scene_of({at(1, item(filled({key(0, many_lines(30'000))}), {}, "small")),
                                   at(2, item(filled({key(0, many_lines(35'530))}), {}, "large"))});
    CHECK(written(scene).size() > 0); // 65534
    scene.items.push_back(at(3, item(filled({key(0, lines({{0, 0}, {1, 0}}))}), {}, "last")));
    const Diagnostic error = refusal(scene);
    CHECK(error.place.offset == 2);
    CHECK(error.message ==
          "the scene needs 65537 edges, the format holds 65534; object \"large\" alone needs 35532");
    CHECK(!error.remedy.empty());
}

TEST_CASE("what a symbol needs counts for each of its uses")
{
    const scene::Symbol star{"star", {item(scene::Group{{item(filled({key(0, many_lines(998))}))}})}};
    const scene::Symbol sky{"sky", uses(40, 0)};
    scene::Scene scene = scene_of(uses(65, 0), {star, sky});
    CHECK(written(scene).size() > 0);
    scene.items.push_back(at(9, item(scene::Group{{at(7, item(scene::Use{1}))}})));
    const Diagnostic error = refusal(scene);
    CHECK(error.place.offset == 7);
    CHECK(
        error.message ==
        "the scene needs 105000 edges, the format holds 65534; this use of symbol \"sky\" alone needs 40000");
}

TEST_CASE("too many items are an error at the use with the most")
{
    scene::Scene scene = scene_of(uses(255, 1), {{"dust", {}}, {"cloud", uses(256, 0)}});
    CHECK(written(scene).size() > 0); // 255 * 257 = 65535
    scene.items.push_back(at(5, item(scene::Group{})));
    const Diagnostic error = refusal(scene);
    CHECK(
        error.message ==
        "the scene needs 65536 items, the format holds 65535; this use of symbol \"cloud\" alone needs 257");
}

TEST_CASE("symbols that multiply beyond all numbers are refused too")
{
    std::vector<scene::Symbol> symbols{{"0", {item(filled({key(0, many_lines(10))}))}}};
    for (std::size_t i = 0; i < 7; ++i)
        symbols.push_back({std::to_string(i + 1), uses(2000, i)});
    Diagnostics diagnostics;
    CHECK(!write_scene(scene_of(uses(2000, 7), symbols), diagnostics));
    CHECK(diagnostics.sorted().size() == 2); // edges and items
}

TEST_CASE("points of all keys count, those of symbols once")
{
    scene::Object heavy = filled({});
    for (int frame = 0; frame < 64; ++frame)
        heavy.keys.push_back(key(frame, many_lines(65'534)));
    heavy.fill.reset();
    heavy.stroke = scene::StrokeStyle{};
    Diagnostics diagnostics;
    CHECK(!write_scene(scene_of({item(scene::Use{0}), item(scene::Use{0})}, {{"s", {item(heavy, {}, "h")}}}),
                       diagnostics));
    bool has_points = false;
    for (const Diagnostic& error : diagnostics.sorted())
        has_points = has_points || error.message.starts_with("the scene needs 4194304 points");
    CHECK(!has_points); // 64 * 65536, which is allowed
    heavy.keys.push_back(key(64, {}));
    Diagnostics more;
    CHECK(!write_scene(scene_of({item(scene::Use{0})}, {{"s", {item(heavy, {}, "h")}}}), more));
    for (const Diagnostic& error : more.sorted())
        has_points = has_points ||
                     error.message ==
                         "the scene needs 4194305 points in all keys together, the format holds 4194304; "
                         "object \"h\" alone needs 4194305";
    CHECK(has_points);
}

}
