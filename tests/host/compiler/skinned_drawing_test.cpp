#include "host/compiler/carry/skinned_drawing.hpp"

#include "core/scene/kfb_limits.hpp"
#include "tests/host/compiler/scene_parts.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace kfast::test {
namespace {

const scene::Binding a{{0, 65'536}};
const scene::Binding b{{1, 65'536}};
const scene::Binding half{{0, 32'768}, {1, 32'768}};

scene::Drawing joined(const scene::Drawing& first, const scene::Drawing& second)
{
    scene::Drawing both = first;
    both.strokes.insert(both.strokes.end(), second.strokes.begin(), second.strokes.end());
    return both;
}

scene::Drawing long_line(std::size_t segments)
{
    scene::Drawing drawing = lines({{0, 0}});
    for (std::size_t i = 1; i <= segments; ++i)
        drawing.strokes[0].segments.push_back(
            {.cubic = false, .c1 = {}, .c2 = {}, .to = {static_cast<std::int16_t>(i % 2), 0}});
    return drawing;
}

}

TEST_CASE("the first drawing is at rest itself")
{
    const scene::Drawing first = lines({{0, 0}, {16, 0}, {32, 0}});
    const auto skinned = skinned_drawing(first, {a, half, b}, first);
    REQUIRE(skinned);
    CHECK(skinned->drawing == first);
    CHECK(!skinned->at_rest);
    CHECK(skinned->bindings == std::vector{a, half, b});
}

TEST_CASE("a drawing with as many points rests on the first as it is")
{
    const scene::Drawing first = lines({{0, 0}, {16, 0}, {32, 0}});
    const scene::Drawing second = lines({{0, 0}, {16, 9}, {32, 0}});
    const auto skinned = skinned_drawing(first, {a, half, b}, second);
    REQUIRE(skinned);
    CHECK(skinned->drawing == second);
    CHECK(skinned->at_rest == first);
    CHECK(skinned->bindings == std::vector{a, half, b});
}

TEST_CASE("where a drawing has more points, the first is divided, and its neighbours' bindings mixed")
{
    const scene::Drawing first = lines({{0, 0}, {32, 0}});
    const scene::Drawing second = lines({{0, 8}, {16, 8}, {24, 8}, {32, 8}, {48, 8}});
    const auto skinned = skinned_drawing(first, {a, b}, second);
    REQUIRE(skinned);
    CHECK(skinned->drawing == second);
    CHECK(skinned->at_rest == lines({{0, 0}, {8, 0}, {16, 0}, {24, 0}, {32, 0}}));
    CHECK(skinned->bindings ==
          std::vector<scene::Binding>{a, {{0, 49'152}, {1, 16'384}}, half, {{1, 49'152}, {0, 16'384}}, b});
}

TEST_CASE("where a drawing has fewer points, it is divided itself; strokes each for themselves")
{
    const scene::Drawing first = joined(lines({{0, 0}, {16, 0}, {32, 0}}), lines({{0, 16}}));
    const scene::Drawing second = joined(lines({{0, 8}, {64, 8}}), lines({{0, 32}, {16, 32}, {32, 32}}));
    const auto skinned = skinned_drawing(first, {a, half, b, b}, second);
    REQUIRE(skinned);
    CHECK(skinned->drawing ==
          joined(lines({{0, 8}, {32, 8}, {64, 8}}), lines({{0, 32}, {16, 32}, {32, 32}})));
    CHECK(skinned->rest() == joined(lines({{0, 0}, {16, 0}, {32, 0}}), lines({{0, 16}, {0, 16}, {0, 16}})));
    CHECK(skinned->bindings == std::vector{a, half, b, b, b, b});
}

TEST_CASE("lines that meet curves become curves")
{
    const scene::Drawing first = lines({{0, 0}, {48, 0}});
    const scene::Drawing second = curve({0, 0}, {0, 32}, {48, 32}, {48, 0});
    const auto skinned = skinned_drawing(first, {a, b}, second);
    REQUIRE(skinned);
    CHECK(skinned->drawing == second);
    CHECK(skinned->rest() == curve({0, 0}, {16, 0}, {32, 0}, {48, 0}));
}

TEST_CASE("an empty drawing has no bindings")
{
    const auto skinned = skinned_drawing(lines({{0, 0}, {48, 0}}), {a, b}, {});
    REQUIRE(skinned);
    CHECK(skinned->drawing == scene::Drawing{});
    CHECK(!skinned->at_rest);
    CHECK(skinned->bindings.empty());
}

TEST_CASE("what takes more points than a drawing holds is refused")
{
    const scene::Drawing first = joined(long_line(65'000), lines({{0, 0}, {1, 1}}));
    const std::vector<scene::Binding> bindings(point_count(first), a);
    CHECK(skinned_drawing(first, bindings, joined(lines({{0, 0}, {1, 0}}), long_line(532))));
    CHECK(!skinned_drawing(first, bindings, joined(lines({{0, 0}, {1, 0}}), long_line(534))));
}

}
