#include "host/sound/deflection.hpp"
#include "host/sound/wave_file.hpp"
#include "tests/compiled.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <string>

using namespace kfast;
using kfast::test::compiled;

namespace {

/// Two lines that move, so that the beam travels, and no two pictures begin at one place.
const std::string moving = R"(
object a stroke="#ffffff" width=1 {
    key 0 { line 10 10 90 10 }
    key 12 { line 10 90 90 90 }
}
object b stroke="#ffffff" width=1 {
    key 0 { line 90 90 10 60 20 50 }
    key 12 { line 10 10 60 10 50 20 }
}
)";

const std::string still = R"(
object a stroke="#ffffff" width=1 { line 10 10 90 10 90 90 }
)";

/// A scene, and a wave of it.
struct Wave {
    std::vector<std::byte> bytes;
    SceneView scene;
    Timeline timeline;
    std::uint64_t samples;
    BeamSource source;
    SoundLoop loop;

    explicit Wave(const std::string& text, const std::string& canvas = "fps=30 loop=repeat",
                  std::uint32_t rate = 48'000, std::uint64_t wanted = 0)
        : bytes{compiled("kfast 1\ncanvas 100 100 " + canvas + "\n" + text)},
          scene{*SceneView::parse(bytes)},
          timeline{timeline_of(scene)},
          samples{wanted == 0 ? sound_length(timeline, rate) : wanted},
          source{scene, profile(rate), static_cast<std::uint32_t>(samples)},
          loop{sound_loop(source, timeline, samples)}
    {
    }

    static BeamProfile profile(std::uint32_t rate)
    {
        BeamProfile profile = sound_profile;
        profile.rate = rate;
        return profile;
    }

    bool is_at(std::size_t place, const Tour& tour) const
    {
        return place + tour.size() <= loop.points.size() &&
               std::equal(tour.begin(), tour.end(), loop.points.begin() + static_cast<std::ptrdiff_t>(place));
    }
};

/// Rounding moves both ends of a step by up to half a unit in x and y.
constexpr double rounding = 1.5;

}

TEST_CASE("a wave is exactly as long as the play, at any rate")
{
    for (const std::uint32_t rate : {44'100u, 48'000u, 96'000u, 192'000u}) {
        CAPTURE(rate);
        const Wave wave{moving, "fps=30 loop=repeat", rate};
        CHECK(wave.loop.points.size() == rate * 12 / 30);
    }
    CHECK(Wave(moving, "fps=30 loop=once").loop.points.size() == 48'000 * 13 / 30);
    CHECK(Wave(moving, "fps=30 loop=ping-pong").loop.points.size() == 48'000 * 24 / 30);
    CHECK(Wave(moving, "fps=29.97 loop=repeat").loop.points.size() == 19'219); // 12 / 29.97 s are 19219.22
    CHECK(Wave(moving, "fps=30 loop=repeat", 44'100, 100'001).loop.points.size() == 100'001);
}

TEST_CASE("nothing clicks: no step is longer than the beam travels, neither between pictures nor at the end")
{
    for (const char* loop : {"fps=30 loop=repeat", "fps=30 loop=once", "fps=47 loop=ping-pong"})
        for (const std::uint32_t rate : {44'100u, 96'000u}) {
            CAPTURE(loop);
            CAPTURE(rate);
            const Wave wave{moving, loop, rate};
            CHECK(wave.loop.sped_up_tours == 0);
            CHECK(wave.loop.incomplete_tours == 0);
            CHECK(longest_step(wave.loop.points) <= sound_profile.travel_step + rounding);
            CHECK(longest_step(wave.loop.points) > sound_profile.lit_step);
        }
}

TEST_CASE("a still scene is the points of its picture, tour after tour, and slower ones at the end")
{
    Wave wave{still, "fps=30 loop=repeat", 48'000, 48'000};
    const Tour tour = tour_of(wave.source.show(Time{0}));
    CHECK(wave.loop.tours == 48'000 / tour.size());
    for (std::size_t number = 0; number + 8 < wave.loop.tours; ++number)
        CHECK(wave.is_at(number * tour.size(), tour));
    CHECK(longest_step(wave.loop.points) <= longest_step(tour) + rounding);
}

TEST_CASE("each frame comes when it is due, or at the end of the tour before, and none drifts")
{
    Wave wave{moving, "fps=30 loop=repeat"};
    for (int frame = 1; frame < 11; ++frame) {
        CAPTURE(frame);
        const Tour tour = tour_of(wave.source.show(Time::frame(frame)));
        const std::size_t due = 1600 * static_cast<std::size_t>(frame);
        std::size_t late = 0;
        while (late < 1600 && !wave.is_at(due + late, tour))
            ++late;
        CHECK(late <= tour.size() + 30); // one tour, and the way between them
    }
}

TEST_CASE("the middle is where the beam is on average")
{
    CHECK(mean_place({{10, 0}, {20, -4}, {30, -8}}) == FieldPoint{20, -4});
    CHECK(mean_place(Tour(70'000, {-32768, 32767})) == FieldPoint{-32768, 32767});
    CHECK(longest_step({{0, 0}, {3, 4}}) == 5);
    CHECK(longest_step({{0, 0}, {0, 1}, {0, 9}}) == 9);
}

TEST_CASE("a wave that is shorter than a tour is drawn in haste")
{
    const Wave wave{moving, "fps=30 loop=repeat", 48'000, 60};
    CHECK(wave.loop.points.size() == 60);
    CHECK(wave.loop.sped_up_tours > 0);
}
