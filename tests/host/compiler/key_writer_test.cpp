#include "host/compiler/write/key_writer.hpp"

#include "tests/host/compiler/scene_parts.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// A line in `count` steps of 10 px, and one stroke.
scene::Drawing steps(int count)
{
    scene::Stroke stroke;
    for (int i = 1; i <= count; ++i)
        stroke.segments.push_back(
            {.cubic = false, .c1 = {}, .c2 = {}, .to = {static_cast<std::int16_t>(160 * i), 0}});
    return {{stroke}};
}

}

TEST_CASE("a way by length that takes too many points is an error at its key")
{
    scene::Drawing parts = steps(200); // each part of the other stroke gets as many points as the largest
    for (std::int16_t i = 0; i < 400; ++i)
        parts.strokes.push_back(lines({{0, i}, {16, i}}).strokes.front());
    scene::Object object = filled({key(0, steps(3)), key(1, parts)});
    object.keys[0].match = scene::Match::length;
    object.keys[0].place = {17, 3};
    Diagnostics diagnostics;
    CHECK(!write_scene(scene_of({item(object)}), diagnostics));
    REQUIRE(diagnostics.sorted().size() == 1);
    CHECK(diagnostics.sorted()[0].place.offset == 17);
    CHECK(diagnostics.sorted()[0].message.find("more than 65535 points") != std::string::npos);
}

}
