#include "host/svg/markup/length.hpp"
#include "host/svg/markup/transform_list.hpp"
#include "host/svg/poses/layer_keys.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::svg;

TEST_CASE("lengths have units, at 96 px to the inch")
{
    const Measure measure{200, 100, 10, 12};
    CHECK(length("12", Axis::x, measure) == 12);
    CHECK(length(" -1.5e1px ", Axis::x, measure) == -15);
    CHECK(length("1in", Axis::x, measure) == 96);
    CHECK(length("2.54cm", Axis::x, measure) == doctest::Approx(96));
    CHECK(length("25.4mm", Axis::x, measure) == doctest::Approx(96));
    CHECK(length("72pt", Axis::x, measure) == doctest::Approx(96));
    CHECK(length("6pc", Axis::x, measure) == 96);
    CHECK(length("2em", Axis::x, measure) == 20);
    CHECK(length("2rem", Axis::x, measure) == 24);
    CHECK(length("2ch", Axis::x, measure) == 10);
    CHECK(length("10%", Axis::x, measure) == 20);
    CHECK(length("10%", Axis::y, measure) == 10);
    CHECK(length("10%", Axis::diagonal, measure) == doctest::Approx(15.8114));
    CHECK_FALSE(length("auto", Axis::x, measure));
    CHECK_FALSE(length("3furlongs", Axis::x, measure));
    CHECK_FALSE(length("1e999", Axis::x, measure));
}

TEST_CASE("shares are numbers or percentages")
{
    CHECK(share("0.25") == 0.25);
    CHECK(share("25%") == 0.25);
    CHECK_FALSE(share("25px"));
}

TEST_CASE("transforms are applied from the right")
{
    const auto of = [](std::string_view text) {
        return transform_list(text).value().of(kfast::scene::Vec2{1, 0});
    };
    CHECK(of("translate(10)").x == 11);
    CHECK(of("translate(10 20)").y == 20);
    CHECK(of("translate(10, 20) scale(2)").x == 12);
    CHECK(of("scale(2)translate(10 20)").x == 22);
    CHECK(of("scale(2 3), translate(0,1)").y == 3);
    CHECK(of("rotate(90)").y == doctest::Approx(1));
    CHECK(of("rotate(180 5 5)").x == doctest::Approx(9));
    CHECK(of("rotate(0.25turn)").y == doctest::Approx(1));
    CHECK(of("skewY(45)").y == doctest::Approx(1));
    CHECK(of("matrix(1 2 3 4 5 6)").x == 6);
    CHECK(of("translateX(2px) scaleX(-1)").x == 1);
    CHECK(of("none").x == 1);
    CHECK(of("").x == 1);
}

TEST_CASE("what is no transform of the plane")
{
    for (const char* text :
         {"rotate", "rotate(", "rotate()", "rotate(1 2)", "rotate(x)", "twist(3)", "matrix(1 2 3)",
          "translate(1 2 3)", "rotate3d(1,1,1,45deg)", "translate(50%)", ") rotate(2)"})
        CHECK_MESSAGE(!transform_list(text), text);
}

TEST_CASE("names of layers tell frames")
{
    const auto frame = [](std::string_view name) { return layer_time(name, 20); };
    CHECK(frame("0") == 0);
    CHECK(frame("12") == 12);
    CHECK(frame("frame 24") == 24);
    CHECK(frame("Frame24") == 24);
    CHECK(frame("f 7.5") == 7.5);
    CHECK(frame("24: smile") == 24);
    CHECK(frame("f3: f") == 3);
    CHECK(frame("(s)0.5") == 10);
    CHECK(frame("0.5s") == 10);
    CHECK(frame("0.5 s: blink") == 10);
    CHECK(frame("500ms") == 10);
    CHECK(frame("(ms) 500") == 10);
    for (const char* name : {"", "Layer 1", "arm", "12 arms", "-3", "f", "frame", "frame 3s", "1e999"})
        CHECK_MESSAGE(!frame(name), name);
}
