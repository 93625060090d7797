#include "core/scene/check/scene_check.hpp"

#include "core/scene/kfb_limits.hpp"
#include "tests/core/acceptance.hpp"
#include "tests/core/raw_bones.hpp"
#include "tests/core/raw_drawing.hpp"

#include <doctest/doctest.h>

/// Points of drawings and of paths, and the end that there is to reading them.
namespace kfast::test {
namespace {

/// An item that is never seen, so that what it shows costs nothing.
Bytes unseen(const Bytes& keys)
{
    return joined({bytes({0x0C, 1}), fixed_track(Property::visible, 0), bytes({1}), keys});
}

bool takes_drawing(const Bytes& drawing)
{
    RawScene scene;
    scene.drawings = drawing;
    scene.items = unseen(one_key());
    return is_accepted(scene);
}

/// A drawing that begins at 0, moved so that it begins at `x`.
Bytes moved(const scene::Drawing& drawing, std::int32_t x)
{
    const Bytes bytes = packed(drawing);
    return joined({{bytes[0]}, signed_varint(x), {bytes.begin() + 2, bytes.end()}});
}

/// As many segments, which do not move.
Bytes stroke_of(std::uint32_t segments)
{
    return joined({bytes({0, 0, 0, 1}), varint(2 * segments), Bytes((segments + 3) / 4)});
}

/// An item that follows the path at 0 of as many segments, each as long as the format has it at least.
Bytes along_path(std::uint32_t segments)
{
    const Bytes path = path_bytes(false, 0, std::vector<std::uint32_t>(segments, 1));
    return joined({bytes({0x05, 1}), fixed_track(Property::along, 7), path, block({})});
}

}

TEST_CASE("control points have coordinates of 16 bits, too, where the ends of their curve have them")
{
    const scene::Segment first{.cubic = true, .c1 = {160, 0}, .c2 = {0, 0}, .to = {16, 0}};
    const scene::Segment second{.cubic = true, .c1 = {0, 0}, .c2 = {160, 0}, .to = {16, 0}};
    for (const scene::Segment& segment : {first, second}) {
        const scene::Drawing curve{{{.from = {}, .segments = {segment}}}};
        CHECK(takes_drawing(moved(curve, kfb::max_coordinate - 160)));
        CHECK_FALSE(takes_drawing(moved(curve, kfb::max_coordinate - 159)));
    }
}

TEST_CASE("a drawing has at most 65535 points, on one stroke or on several")
{
    CHECK(takes_drawing(joined({bytes({1}), stroke_of(65'534)})));
    CHECK_FALSE(takes_drawing(joined({bytes({1}), stroke_of(65'535)})));
    CHECK_FALSE(takes_drawing(joined({bytes({1}), stroke_of(65'536)})));
    CHECK(takes_drawing(joined({bytes({2}), stroke_of(40'000), stroke_of(25'533)})));
    CHECK_FALSE(takes_drawing(joined({bytes({2}), stroke_of(40'000), stroke_of(25'534)})));
}

TEST_CASE("there is an end to the strokes that are read, of points alone as well")
{
    const Bytes points = joined({varint(1'000), repeated(bytes({0, 0, 0, 1, 0}), 1'000)});
    const auto takes_keys = [&points](std::size_t count) {
        auto second = static_cast<std::uint32_t>(points.size());
        while ((second ^ second >> 5) % 32 != 0) // where the one makes the other forgotten
            ++second;
        std::vector<RawKey> keys(count);
        for (std::size_t i = 0; i < count; ++i)
            keys[i] = {.time = {static_cast<std::int32_t>(i)}, .drawing = i % 2 == 0 ? 0 : second};
        RawScene scene;
        scene.drawings = joined({points, Bytes(second - points.size()), points});
        scene.items = unseen(key_bytes(keys));
        return is_accepted(scene);
    };
    CHECK(takes_keys(250)); // 250 * (1 + 1000)
    CHECK_FALSE(takes_keys(300));
}

TEST_CASE("a path lies within coordinates of 16 bits")
{
    const scene::Drawing line{{polyline_of({{0, 0}, {160, 0}})}};
    const auto takes_from = [&line](std::int32_t x) {
        RawScene scene;
        scene.drawings = moved(line, x);
        scene.items = along_path(1);
        return is_accepted(scene);
    };
    CHECK(takes_from(kfb::min_coordinate));
    CHECK_FALSE(takes_from(kfb::min_coordinate - 1)); // ends within
    CHECK(takes_from(kfb::max_coordinate - 160));
    CHECK_FALSE(takes_from(kfb::max_coordinate - 159)); // begins within
}

TEST_CASE("the segments of paths count as read")
{
    const auto takes_behind = [](int keys, std::uint32_t segments) {
        KeyTimes key_times;
        for (int i = 0; i < keys; ++i)
            key_times.push_back({Time{i}, 0});
        Bytes tracks = joined({bytes({0}), key_time_bytes(key_times), bytes({0, 0})});
        for (const Property property : {Property::y, Property::rotation, Property::opacity})
            tracks = joined({tracks, bytes({static_cast<int>(property), 0, 0, 0})}); // the same key times
        RawScene scene;
        scene.ticks = 100 * 1024;
        scene.drawings = joined({bytes({1}), stroke_of(segments)});
        scene.items = joined({bytes({0x05, 4}), tracks, bytes({0}), along_path(segments)});
        const auto size = scene.file().size();
        const bool is_allowed = ReadAllowance{size}.take(4 * static_cast<std::uint32_t>(keys) + segments);
        CHECK(is_accepted(scene) == is_allowed);
        CHECK(ReadAllowance{size}.take(4 * static_cast<std::uint32_t>(keys)));
        return is_allowed;
    };
    CHECK(takes_behind(70'000, 1'000));
    CHECK_FALSE(takes_behind(70'400, 1'000));
}

TEST_CASE("there is an end to the skeletons that are passed over on the way to one")
{
    const auto takes_objects = [](std::size_t count) {
        RawScene scene;
        scene.bones = repeated(skeleton_bytes({{}, std::vector<RawBone>(1)}), 255);
        scene.drawings = bytes({0});
        scene.items =
            repeated(joined({bytes({0x88, 1, 255}), key_bytes({{.drawing = 0, .more = -1}})}), count);
        return is_accepted(scene);
    };
    CHECK(takes_objects(1'000)); // 1000 * (254 + 2)
    CHECK_FALSE(takes_objects(1'200));
}

TEST_CASE("there is an end to the keys of bones that are read, common ones and a bone's own")
{
    KeyTimes many;
    for (int i = 0; i < 60'000; ++i)
        many.push_back({Time{i}, 0});
    const Bytes keys = key_time_bytes(many);
    const Bytes straight = bytes({0xC0, 0, 0, 2}); // at 0, 0, two pixels long, without keys
    const Bytes common = block(joined({bytes({1}), keys, bytes({0}), straight}));
    const Bytes own = block(joined({bytes({1, 0, 0, 0xC2, 0, 0, 2}), keys, bytes({0, 10})}));
    const auto takes_skeletons = [](const Bytes& skeleton, std::size_t count) {
        RawScene scene;
        scene.bones = repeated(skeleton, count);
        return is_accepted(scene);
    };
    for (const Bytes& skeleton : {common, own}) {
        CHECK(takes_skeletons(skeleton, 4));
        CHECK_FALSE(takes_skeletons(skeleton, 20));
    }
}

}
