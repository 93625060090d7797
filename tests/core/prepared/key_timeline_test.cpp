#include "core/prepared/key_timeline.hpp"

#include "tests/core/player_fixture.hpp"
#include "tests/core/triangle_state.hpp"

#include <doctest/doctest.h>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

/// The number of a pair behind those of tests/core/triangle_state.hpp.
constexpr int hold_both = 4;

/// A triangle whose x has these keys.
struct KeyedTriangle {
    Bytes file;
    SceneView scene;
    TrackKeyCursor keys;

    explicit KeyedTriangle(const std::vector<RawTrackKey>& list)
        : file{file_with(list)}, scene{accepted(file)}, keys{scene.items().next().tracks.next().keys}
    {
    }

    KeyTimeline timeline() const
    {
        return {scene.place_of(keys.key_times().place()), keys.key_times().driver()};
    }

private:
    static Bytes file_with(const std::vector<RawTrackKey>& list)
    {
        RawScene raw;
        raw.ticks = 1 << 20;
        raw.law_count = 4;
        raw.laws = joined({triangle_laws(), bytes({0xF4})});
        raw.items = tracked(1, moving_track(Property::x, list));
        return raw.file();
    }
};

std::vector<RawTrackKey> random_keys(std::mt19937& random)
{
    std::vector<RawTrackKey> keys;
    std::int32_t ticks = random() % 2 == 0 ? 0 : static_cast<std::int32_t>(random() % 5000);
    for (std::size_t count = 2 + random() % 8; count > 0; --count) {
        keys.push_back({{ticks}, static_cast<int>(random() % 5), static_cast<std::int32_t>(count)});
        ticks += 1 + static_cast<std::int32_t>(random() % 4000);
    }
    return keys;
}

bool is_as_searched(const KeyTimeline& timeline, const KeyedTriangle& triangle, Time time)
{
    const auto [from, to] = interval_at(triangle.keys.key_times(), time);
    return timeline.from() == from.index && timeline.to() == to.index && timeline.now() == time &&
           timeline.is_between() == (from.index != to.index) &&
           timeline.progress() ==
               progress_between(from.time, to.time, time, triangle.scene.laws(from.laws), nullptr);
}

}

TEST_CASE("wherever a timeline goes, it stands where a search from the beginning would")
{
    std::mt19937 random{30};
    for (int round = 0; round < 200; ++round) {
        const std::vector<RawTrackKey> keys = random_keys(random);
        const KeyedTriangle triangle{keys};
        KeyTimeline timeline = triangle.timeline();
        const std::int32_t end = keys.back().time.ticks + 1000;
        const auto stands_right = [&](std::int32_t ticks) {
            timeline.move_to({ticks}, triangle.scene);
            return is_as_searched(timeline, triangle, {ticks});
        };
        for (std::int32_t ticks = 0; ticks < end; ticks += 97) // forwards
            REQUIRE(stands_right(ticks));
        for (std::int32_t ticks = end; ticks >= 0; ticks -= 131) // backwards
            REQUIRE(stands_right(ticks));
        for (int leap = 0; leap < 30; ++leap)
            REQUIRE(stands_right(static_cast<std::int32_t>(random() % static_cast<unsigned>(end))));
        for (const RawTrackKey& key : keys) {
            REQUIRE(stands_right(key.time.ticks));
            REQUIRE(stands_right(std::max(key.time.ticks - 1, 0)));
        }
    }
}

TEST_CASE("a timeline tells what has moved since the moment before")
{
    // constant from 1 to 3, held from there to 6
    const KeyedTriangle triangle{{{{1000}, 0, 5}, {{3000}, hold_both, 7}, {{6000}, 0, 9}}};
    KeyTimeline timeline = triangle.timeline();
    struct Moved {
        bool to_other_keys;
        bool at_all;
        bool operator==(const Moved&) const = default;
    };
    const auto moved_to = [&](std::int32_t ticks) {
        timeline.move_to({ticks}, triangle.scene);
        return Moved{timeline.has_other_keys(), timeline.has_moved()};
    };
    constexpr Moved no{false, false};
    constexpr Moved further{false, true};
    constexpr Moved elsewhere{true, true};
    CHECK(moved_to(0) == elsewhere); // it stood nowhere
    CHECK(moved_to(999) == no);
    CHECK(moved_to(1000) == elsewhere);
    CHECK(moved_to(1000) == no);
    CHECK(moved_to(2000) == further);
    CHECK(moved_to(1500) == further);
    CHECK(moved_to(3000) == elsewhere);
    CHECK(moved_to(5999) == no);
    CHECK(moved_to(6000) == elsewhere);
    CHECK(moved_to(9000) == no);
    CHECK(moved_to(0) == elsewhere);
    CHECK(moved_to(2000) == elsewhere);
    CHECK(timeline.is_held(triangle.scene) == false);
    CHECK(moved_to(4000) == elsewhere);
    CHECK(timeline.is_held(triangle.scene));
    timeline.move_with_time();
    CHECK(moved_to(5000) == further);
}

TEST_CASE("a smooth curve needs the key before and the key behind")
{
    const KeyedTriangle triangle{{{{100}, 0, 5}, {{300}, 0, 7}, {{600}, 0, 9}, {{1000}, 0, 1}}};
    KeyTimeline timeline = triangle.timeline();
    const auto around = [&](std::int32_t ticks) {
        timeline.move_to({ticks}, triangle.scene);
        return std::vector<int>{timeline.time_before().ticks, timeline.from_time().ticks,
                                timeline.to_time().ticks, timeline.time_after(triangle.scene).ticks};
    };
    CHECK(around(200) == std::vector{100, 100, 300, 600});
    CHECK(around(300) == std::vector{100, 300, 600, 1000});
    CHECK(around(700) == std::vector{300, 600, 1000, 1000});
    CHECK(around(299) == std::vector{100, 100, 300, 600});
}

}
