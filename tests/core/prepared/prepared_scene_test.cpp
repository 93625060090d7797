#include "core/prepared/prepared_scene.hpp"

#include "core/time/track.hpp"
#include "tests/core/moved_scene.hpp"
#include "tests/core/player_fixture.hpp"
#include "tests/core/raw_bones.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// The item with this number, from 0, in the order of the text.
const Node& item_of(const PreparedScene& prepared, std::size_t number)
{
    return prepared.nodes()[number + 1];
}

}

TEST_CASE("a scene is laid out once, symbols once however often they are used")
{
    const Bytes bytes = compiled(R"kfast(
kfast 1
canvas 40 40 frames=20
symbol leaf { object a fill=red { rect 2 2 9 9 }; object b fill=blue { rect 4 4 9 9; key 0 x=0; key 5 x=9 } }
use leaf x=3
group { use leaf y=4; object c fill=lime { rect 1 1 4 4 } }
)kfast");
    const SceneView scene = accepted(bytes);
    CHECK(scene.records().nodes == 8); // the symbol and two, the scene and four, of which one is a use
    CHECK(scene.records().timelines == 1);
    CHECK(scene.records().bones == 0);
    CHECK(PreparedScene::bytes_for(scene) ==
          sizeof(KeyTimeline) + scene.records().tracks * sizeof(TrackState) + 8 * sizeof(Node) +
              4 * sizeof(WalkLevel)); // the scene, the group, the use, its objects
    MovedScene moved{scene};
    const PreparedScene& prepared = moved.at({});
    CHECK(prepared.root().end == 8);
    const Node& first = *(&prepared.root() + 1);
    CHECK(first.kind == ItemKind::use);
    CHECK(&prepared.inside(first) == prepared.nodes().data());
    CHECK(prepared.inside(first).end == 3);
    const Node& group = prepared.nodes()[first.end];
    CHECK(group.kind == ItemKind::group);
    CHECK(&prepared.inside(group) == &group);
    CHECK(group.end == 8);
}

TEST_CASE("tracks with the same key times share a timeline, single keys need none")
{
    const std::vector<RawTrackKey> keys{{{}, 0, 16}, {Time::frame(4), 0, 160}};
    RawScene raw;
    raw.items =
        joined({tracked(4, joined({moving_track(Property::x, keys), bytes({1, 0}), value_bytes({32, 48}),
                                   moving_track(Property::rotation, {{{}, 0, 77}}),
                                   fixed_track(Property::opacity, 9)})),
                tracked(1, moving_track(Property::x, keys))});
    const Bytes file = raw.file();
    const SceneView scene = accepted(file);
    CHECK(scene.records().timelines == 2);
    MovedScene moved{scene};
    const PreparedScene& prepared = moved.at(Time::frame(1));
    const auto tracks = prepared.tracks(item_of(prepared, 0));
    REQUIRE(tracks.size() == 4);
    CHECK(tracks[0].timeline == tracks[1].timeline);
    CHECK_FALSE(tracks[2].has_timeline());
    CHECK_FALSE(tracks[3].has_timeline());
    CHECK(prepared.tracks(item_of(prepared, 1))[0].timeline != tracks[0].timeline);
    CHECK(prepared.fine_value(scene, tracks[0]) == 52 << fine_bits);
    CHECK(prepared.fine_value(scene, tracks[1]) == 36 << fine_bits);
    CHECK(prepared.fine_value(scene, tracks[2]) == 77 << fine_bits);
    CHECK(prepared.fine_value(scene, tracks[3]) == 9 << fine_bits);
}

TEST_CASE("a track depends on its keys, and on its way where its values differ")
{
    RawScene raw;
    raw.items =
        tracked(1, moving_track(Property::x,
                                {{Time::frame(1), 0, 5}, {Time::frame(2), 0, 5}, {Time::frame(3), 0, 8}}));
    const Bytes file = raw.file();
    const SceneView scene = accepted(file);
    MovedScene moved{scene};
    const auto dependence_at = [&](int frame) {
        const PreparedScene& prepared = moved.at(Time::frame(frame));
        return prepared.dependence(prepared.tracks(item_of(prepared, 0))[0]);
    };
    CHECK(dependence_at(0) == Dependence{1, 0});
    CHECK(dependence_at(1) == Dependence{1, 0});
    CHECK(dependence_at(2) == Dependence{1, 1});
    CHECK(dependence_at(3) == Dependence{1, 0});
}

TEST_CASE("bones have one node each, with all parents in front of them, skeleton after skeleton")
{
    RawSkeleton first{.common = {{{}}, {Time::frame(5)}}, .bones = {{}, {.parent = 1}}};
    first.bones[0].keys[of_bone::angle].common = {0, 1000};
    first.bones[1].keys[of_bone::x].own = {{{}, 0, 16}, {Time::frame(3), 0, 32}};
    first.bones[1].keys[of_bone::y].common = {7, 7};
    const RawSkeleton second{.common = {}, .bones = {{}, {.parent = 1}}};
    RawScene raw;
    raw.bones = joined({skeleton_bytes(first), skeleton_bytes(second)});
    const Bytes file = raw.file();
    const SceneView scene = accepted(file);
    MovedScene moved{scene};
    const PreparedScene& prepared = moved.at(Time::frame(1));
    REQUIRE(prepared.bones().size() == 4);
    CHECK(prepared.bones()[0].parent == 0);
    CHECK(prepared.bones()[1].parent == 1);
    CHECK(prepared.bones()[2].parent == 0);
    CHECK(prepared.bones()[3].parent == 3);
    CHECK(scene.records().timelines == 2);
    CHECK(prepared.bones()[0].dependence == Dependence{0b01, 0b01});
    CHECK(prepared.bones()[1].dependence == Dependence{0b11, 0b11});
    CHECK(prepared.bones()[3].dependence == Dependence{});
    CHECK(moved.at(Time::frame(4)).bones()[1].dependence == Dependence{0b11, 0b01});
}

TEST_CASE("what is told moves what shows it")
{
    const Bytes bytes = compiled(R"kfast(
kfast 1
canvas 40 40 frames=20
input here kind=drawing points=20 strokes=2
input there kind=drawing points=20 strokes=2
object a stroke=red live=here
object b stroke=red live=there
)kfast");
    const SceneView scene = accepted(bytes);
    std::vector<std::uint32_t> memory(PreparedScene::bytes_for(scene) / 4);
    PreparedScene prepared{scene, std::as_writable_bytes(std::span{memory})};
    prepared.move_to(scene, {}, 0);
    prepared.move_to(scene, {}, 0b10);
    CHECK(prepared.dependence_of_input(1).is_touched_by(prepared.moved()));
    CHECK_FALSE(prepared.dependence_of_input(0).is_touched_by(prepared.moved()));
    prepared.move_to(scene, {}, 0);
    CHECK(prepared.moved() == Dependence{});
}

}
