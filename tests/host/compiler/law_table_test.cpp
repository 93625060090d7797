#include "host/compiler/pack/key_time_writer.hpp"

#include "tests/bytes.hpp"
#include "tests/host/compiler/scene_parts.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

LawPair in_steps(int x, int y)
{
    return {VelocityLaw::in_steps(static_cast<std::uint16_t>(x)),
            VelocityLaw::in_steps(static_cast<std::uint16_t>(y))};
}

}

TEST_CASE("a pair of laws has one number, constant and constant 0")
{
    LawTable table;
    CHECK(table.number_of({}, {}) == 0);
    CHECK(table.number_of({VelocityLaw::hold, {}}, {}) == 1);
    CHECK(table.number_of({{}, VelocityLaw::hold}, {}) == 2);
    CHECK(table.number_of(in_steps(2, 3), {}) == 3);
    CHECK(table.number_of(in_steps(2, 4), {}) == 4);
    CHECK(table.number_of({VelocityLaw::hold, {}}, {}) == 1);
    CHECK(table.number_of(in_steps(2, 3), {}) == 3);
    CHECK(table.number_of({}, {}) == 0);
    CHECK(table.count() == 4);
    CHECK(table.bytes() == bytes({0x04, 0x40, 0x55, 2, 0, 3, 0, 0x55, 2, 0, 4, 0}));
}

TEST_CASE("there are 255 numbers, and the first key that finds none is known")
{
    LawTable table;
    for (int number = 1; number <= 255; ++number)
        CHECK(table.number_of(in_steps(number, 1), {}) == static_cast<std::uint32_t>(number));
    CHECK(!table.first_beyond());
    CHECK(table.number_of(in_steps(256, 1), {77, 3}) == 0);
    CHECK(table.number_of(in_steps(257, 1), {88, 3}) == 0);
    CHECK(table.number_of(in_steps(255, 1), {99, 3}) == 255);
    CHECK(table.count() == 255);
    REQUIRE(table.first_beyond());
    CHECK(table.first_beyond()->offset == 77);
}

TEST_CASE("too many pairs of laws are an error at the key that has one too many")
{
    scene::Object object = filled({});
    for (int frame = 0; frame < 258; ++frame) {
        object.keys.push_back(key(frame, {}, in_steps(frame + 1, 1)));
        object.keys.back().place = {static_cast<std::size_t>(frame), 1};
    }
    Diagnostics diagnostics;
    CHECK(!write_scene(scene_of({item(object)}), diagnostics));
    REQUIRE(diagnostics.sorted().size() == 1);
    CHECK(diagnostics.sorted()[0].place.offset == 255);
    CHECK(diagnostics.sorted()[0].message.find("255 different pairs") != std::string::npos);
    object.keys.resize(256); // the laws of the last key lead nowhere
    CHECK(written(scene_of({item(object)})).size() > 0);
}

TEST_CASE("the laws of tracks count as well")
{
    scene::Track track{Property::x, {}};
    for (int frame = 0; frame < 258; ++frame)
        track.keys.push_back(
            {Time::frame(frame), in_steps(frame + 1, 1), frame, {static_cast<std::size_t>(frame), 1}});
    const scene::Object still = filled({key(0, {})});
    Diagnostics diagnostics;
    CHECK(!write_scene(scene_of({item(still, {track})}), diagnostics));
    REQUIRE(diagnostics.sorted().size() == 1);
    CHECK(diagnostics.sorted()[0].place.offset == 255);
    track.keys.resize(256);
    CHECK(written(scene_of({item(still, {track})})).size() > 0);
}

}
