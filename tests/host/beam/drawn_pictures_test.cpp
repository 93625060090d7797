#include "host/beam/beam_screen_source.hpp"

#include "host/beam/beam_source.hpp"
#include "tests/compiled.hpp"

#include <algorithm>
#include <array>
#include <doctest/doctest.h>

namespace kfast::test {
namespace {

const std::vector<std::byte> bytes = compiled(R"(kfast 1
canvas 100 100 fps=30 loop=repeat
object bar stroke="#ffffff" {
    key 0 { line 10 50 90 50 }
    key 15 { line 10 20 50 80 }
    key 30 { line 10 50 90 50 }
}
)");

}

TEST_CASE("a clock of points counts both ways, and rounds down")
{
    const BeamClock clock{30'000, 100'000};
    CHECK(clock.points_at(Time::frame(30)) == 100'000);
    CHECK(clock.points_at({1}) == 3);
    CHECK(clock.points_at({-1}) == -4);
    CHECK(clock.time_at(100'000) == Time::frame(30));
    CHECK(clock.time_at(-1) == Time{-1});
    CHECK(BeamClock{1, 1'000'000}.points_at({(1 << 30) - 1}) == 1'048'575'999'023'437);
}

TEST_CASE("pictures follow each other up to the moment, in whole tours")
{
    const SceneView scene = *SceneView::parse(bytes);
    BeamSource source{scene, galvo_profile};
    constexpr std::int64_t memory = 5000;
    const Time moment = Time::frame(7);
    const std::vector<DrawnPicture> pictures = drawn_pictures(source, scene, moment, memory);
    const std::int64_t now = BeamClock{30'000, galvo_profile.rate}.points_at(moment);
    CHECK(pictures.back().end == now);
    CHECK(pictures.front().begin <= now - memory);
    CHECK(pictures.front().end > now - memory);
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const auto tour = static_cast<std::int64_t>(pictures[i].points.size());
        CHECK(pictures[i].end - pictures[i].begin >= tour);
        if (i + 1 == pictures.size())
            break;
        CHECK(pictures[i].end == pictures[i + 1].begin);
        CHECK((pictures[i].end - pictures[i].begin) % tour == 0);
        CHECK(pictures[i].end - pictures[i].begin >= galvo_profile.rate / 60);
    }
    const auto last = static_cast<std::int64_t>(pictures.back().points.size());
    CHECK((pictures.back().end - pictures.back().begin) % last == now % last);
}

TEST_CASE("the picture at a moment is the last one, and those before are as the scene was")
{
    const SceneView scene = *SceneView::parse(bytes);
    BeamSource source{scene, scope_profile};
    const std::vector<DrawnPicture> pictures = drawn_pictures(source, scene, Time::frame(15), 10'000);
    const std::span<const BeamPoint> points = source.show(Time::frame(15));
    CHECK(std::ranges::equal(pictures.back().points, points));
    CHECK_FALSE(std::ranges::equal(pictures.front().points, points));
}

TEST_CASE("the very end of a scene is shown although it begins again there")
{
    const std::vector<std::byte> moving = compiled(R"(kfast 1
canvas 100 100 fps=30 loop=repeat
object bar stroke="#ffffff" { key 0 { line 10 50 90 50 }
    key 30 { line 10 20 50 80 } }
)");
    const SceneView scene = *SceneView::parse(moving);
    BeamSource source{scene, scope_profile};
    const std::vector<DrawnPicture> pictures = drawn_pictures(source, scene, scene.length(), 1);
    CHECK(std::ranges::equal(pictures.back().points, source.show(scene.length())));
    const std::vector<DrawnPicture> first = drawn_pictures(source, scene, Time{0}, 10'000);
    CHECK(first[first.size() - 2].points.size() != first.back().points.size()); // as at the end before it
}

TEST_CASE("the points of a picture are hashed with their places, colours and light")
{
    const std::array<BeamPoint, 2> points{{
        {{-32768, 258}, {10, 20, 30}},
        {{1, -1}},
    }};
    CHECK(hash(points) == 0xF8FE2820);
    CHECK(hash(std::span{points}.first(1)) != hash(std::span{points}.last(1)));
}

}
