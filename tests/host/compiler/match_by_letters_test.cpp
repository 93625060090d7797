#include "host/compiler/match/match_by_letters.hpp"

#include "core/scene/kfb_limits.hpp"
#include "tests/host/compiler/scene_parts.hpp"

#include <doctest/doctest.h>

#include <vector>

namespace kfast::test {
namespace {

scene::Stroke line(int x, int y, int to_x, int to_y)
{
    return lines({{static_cast<std::int16_t>(x), static_cast<std::int16_t>(y)},
                  {static_cast<std::int16_t>(to_x), static_cast<std::int16_t>(to_y)}})
        .strokes.front();
}

scene::Key key(std::vector<scene::Stroke> strokes, std::vector<std::size_t> letters)
{
    return {.time = {},
            .laws = {},
            .match = scene::Match::letters,
            .drawing = {std::move(strokes)},
            .place = {},
            .letters = std::move(letters)};
}

}

TEST_CASE("letters pair in their order, and their strokes among themselves")
{
    const scene::Key from = key({line(0, 0, 0, 16), line(32, 0, 32, 16)}, {0, 1});
    const scene::Key to = key({line(64, 0, 64, 32), line(96, 0, 96, 32)}, {0, 1});
    const auto matched = match_by_letters(from, to, false);
    REQUIRE(matched);
    CHECK(matched->from == from.drawing);
    CHECK(matched->to == to.drawing);
}

TEST_CASE("a letter without a partner is drawn together to its centre")
{
    const scene::Key few = key({line(0, 0, 0, 16)}, {0});
    const scene::Key many = key({line(64, 0, 64, 32), line(96, 0, 96, 32), line(96, 8, 112, 8)}, {0, 1});
    const auto growing = match_by_letters(few, many, false);
    REQUIRE(growing);
    CHECK(growing->to == many.drawing);
    CHECK(growing->from.strokes ==
          std::vector{line(0, 0, 0, 16), line(104, 16, 104, 16), line(104, 16, 104, 16)});
    const auto shrinking = match_by_letters(many, few, false);
    REQUIRE(shrinking);
    CHECK(shrinking->from == growing->to);
    CHECK(shrinking->to == growing->from);
}

TEST_CASE("a stroke without a partner is drawn together to the centre of the other letter")
{
    const scene::Key few = key({line(0, 0, 0, 16), line(32, 0, 32, 16)}, {0, 1});
    const scene::Key many = key({line(64, 0, 64, 32), line(68, 4, 68, 20), line(96, 0, 96, 32)}, {0, 2});
    const auto matched = match_by_letters(few, many, false);
    REQUIRE(matched);
    CHECK(matched->to == many.drawing);
    CHECK(matched->from.strokes == std::vector{line(0, 0, 0, 16), line(0, 8, 0, 8), line(32, 0, 32, 16)});
}

TEST_CASE("with a stroke, what has no partner comes out of the end of what stands before it")
{
    const scene::Key few = key({line(0, 0, 0, 16)}, {0});
    const scene::Key many = key({line(64, 0, 64, 32), line(96, 0, 96, 32)}, {0, 1});
    const auto matched = match_by_letters(few, many, true);
    REQUIRE(matched);
    CHECK(matched->from.strokes == std::vector{line(0, 0, 0, 16), line(0, 16, 0, 16)});
}

TEST_CASE("letters come out of an empty drawing, each from its centre")
{
    const scene::Key none = key({}, {});
    const scene::Key two = key({line(0, 0, 0, 16), line(8, 4, 8, 12), line(32, 0, 32, 16)}, {0, 2});
    const auto grown = match_by_letters(none, two, false);
    REQUIRE(grown);
    CHECK(grown->from.strokes == std::vector{line(4, 8, 4, 8), line(4, 8, 4, 8), line(32, 8, 32, 8)});
    CHECK(grown->to == two.drawing);
    const auto shrunk = match_by_letters(two, none, false);
    REQUIRE(shrunk);
    CHECK(shrunk->from == two.drawing);
    CHECK(shrunk->to == grown->from);
    CHECK(match_by_letters(two, none, true)->to == grown->from);
    CHECK(match_by_letters(none, none, false)->to == none.drawing);
}

TEST_CASE("a drawing without letters is one")
{
    const scene::Key one = key({line(0, 0, 0, 16), line(32, 0, 32, 16)}, {});
    CHECK(match_by_letters(one, one, false)->from == one.drawing);
}

TEST_CASE("both drawings have room for the points of each other")
{
    const auto long_line = [](std::size_t segments) {
        scene::Stroke stroke{.from = {}, .segments = {}};
        for (std::size_t i = 1; i <= segments; ++i)
            stroke.segments.push_back(
                {.cubic = false, .c1 = {}, .c2 = {}, .to = {static_cast<std::int16_t>(i % 2), 0}});
        return stroke;
    };
    const scene::Key few = key({line(0, 0, 0, 16)}, {0});
    const scene::Key many = key({line(0, 0, 0, 16), long_line(kfb::max_drawing_points - 3)}, {0, 1});
    const scene::Key too_many = key({line(0, 0, 0, 16), long_line(kfb::max_drawing_points - 2)}, {0, 1});
    CHECK(match_by_letters(few, many, false));
    CHECK_FALSE(match_by_letters(few, too_many, false));
}

}
