#include "host/walk/key_times.hpp"

#include "tests/host/compiler/scene_parts.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

scene::Track keyed(Property property, std::initializer_list<int> frames)
{
    scene::Track track{property, {}};
    for (const int frame : frames)
        track.keys.push_back({.time = Time::frame(frame), .laws = {}, .value = frame});
    return track;
}

}

TEST_CASE("keys of drawings and tracks count, in groups and symbols too, each time once")
{
    const scene::Item inner = item(filled({key(5, {}), key(9, {})}), {keyed(Property::x, {5, 7})});
    const scene::Item group = item(scene::Group{{inner}}, {keyed(Property::opacity, {1, 30})});
    const scene::Item in_symbol = item(scene::Group{
        {item(filled({key(2, {})}), {keyed(Property::rotation, {3, 4}), fixed(Property::order, 9)})}});
    const scene::Item use = item(scene::Use{0}, {keyed(Property::y, {0, 8})});
    const std::vector<std::byte> bytes = written(scene_of({group, use}, {{"s", {in_symbol}}}));
    std::vector<int> frames;
    for (const Time time : key_times(*SceneView::parse(bytes)))
        frames.push_back(time.ticks / Time::ticks_per_frame);
    CHECK(frames == std::vector<int>{0, 1, 2, 3, 4, 5, 7, 8, 9, 30});
}

TEST_CASE("keys of backbones count")
{
    scene::Object object = filled({key(5, {})});
    const std::vector<scene::Point> nodes{{0, 0}, {160, 0}};
    for (const int frame : {3, 12})
        object.backbone_keys.push_back({.time = Time::frame(frame),
                                        .laws = {},
                                        .backbones = {{nodes, {{0, -80}, {160, -80}}, {{0, 80}, {160, 80}}}},
                                        .place = {}});
    const std::vector<std::byte> bytes = written(scene_of({item(object)}));
    CHECK(key_times(*SceneView::parse(bytes)) ==
          std::vector<Time>{Time::frame(3), Time::frame(5), Time::frame(12)});
}

}
