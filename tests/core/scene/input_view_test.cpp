#include "core/scene/input_view.hpp"

#include "core/scene/scene_view.hpp"
#include "tests/core/raw_scene.hpp"

#include <doctest/doctest.h>
#include <limits>

namespace kfast::test {
namespace {

constexpr std::int32_t lowest = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t highest = std::numeric_limits<std::int32_t>::max();

std::int32_t place(std::int32_t min, std::int32_t max, std::int32_t value)
{
    return InputView{.name = {}, .min = min, .max = max, .default_value = min}.place_of(value).ticks;
}

}

TEST_CASE("an input stands at 0 at its least value and at 65536 at its greatest")
{
    CHECK(place(-1000, 1000, -1000) == 0);
    CHECK(place(-1000, 1000, 0) == 32768);
    CHECK(place(-1000, 1000, 1000) == 65536);
    CHECK(place(0, 3, 1) == 21845);   // 21845.33
    CHECK(place(0, 3, 2) == 43691);   // 43690.67
    CHECK(place(0, 131'072, 1) == 1); // a half goes up
}

TEST_CASE("a value beyond the range is held within it")
{
    CHECK(place(-30, 70, -31) == 0);
    CHECK(place(-30, 70, 71) == 65536);
    CHECK(place(-1'000'000'000, 1'000'000'000, lowest) == 0);
    CHECK(place(-1'000'000'000, 1'000'000'000, highest) == 65536);
    CHECK(place(-1'000'000'000, 1'000'000'000, 0) == 32768);
}

TEST_CASE("a scene tells its inputs, and finds one by its name")
{
    RawScene scene;
    scene.input_count = 2;
    scene.inputs = joined({input_bytes("gaze", -1000, 1000, 250), input_bytes("rpm", 0, 8'000'000, 900'000)});
    const Bytes file = scene.file();
    const SceneView view = *SceneView::parse(file);
    REQUIRE(view.input_count() == 2);
    InputCursor inputs = view.inputs();
    const InputView gaze = inputs.next();
    CHECK(gaze.name == "gaze");
    CHECK(gaze.min == -1000);
    CHECK(gaze.max == 1000);
    CHECK(gaze.default_value == 250);
    CHECK(inputs.next().name == "rpm");
    CHECK(inputs.at_end());
    CHECK(view.input("rpm") == 1);
    CHECK_FALSE(view.input("Gaze"));
}

}
