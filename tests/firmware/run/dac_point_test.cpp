#include "firmware/run/dac_point.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("the field's ends are the converters' ends")
{
    CHECK(dac_level(-32768) == 0);
    CHECK(dac_level(-32753) == 0);
    CHECK(dac_level(-32752) == 1);
    CHECK(dac_level(0) == 2048);
    CHECK(dac_level(-1) == 2047);
    CHECK(dac_level(32767) == 4095);
}

TEST_CASE("a point is brightness, x and y")
{
    const BeamPoint lit{{-32768, 32767}, {255, 255, 255}};
    CHECK(dac_point(lit, BeamBrightness::by_level) == 0xFF00'0FFF);
    const BeamPoint dark{{32767, -32768}};
    CHECK(dac_point(dark, BeamBrightness::by_level) == 0x00FF'F000);
}

TEST_CASE("colours are as bright as eyes see them, or just lit")
{
    const auto level = [](Colour colour, BeamBrightness brightness = BeamBrightness::by_level) {
        return dac_brightness({{}, colour}, brightness);
    };
    CHECK(level({255, 255, 255}) == 255);
    CHECK(level({255, 0, 0}) == 77);
    CHECK(level({0, 255, 0}) == 149);
    CHECK(level({0, 0, 255}) == 29);
    CHECK(level({0, 0, 0}) == 0);
    CHECK(level({1, 1, 1}) == 1);
    CHECK(level({0, 0, 1}, BeamBrightness::none) == 255);
    CHECK(level({0, 0, 1}, BeamBrightness::by_speed) == 255);
    CHECK(level({255, 255, 255, 0}) == 0);
    CHECK(level({255, 255, 255, 0}, BeamBrightness::by_speed) == 0);
}

}
