#include "tests/core/beam/beam_stage.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace kfast::test {

TEST_CASE("the corners of a line are among its points, with y upwards")
{
    BeamStage stage{R"(kfast 1
        canvas 256 256
        object line stroke=white { line 0 0 256 0 256 256 })"};
    const auto points = stage.points({});
    const auto is_drawn = [&](FieldPoint at) {
        return std::ranges::any_of(points, [at](const BeamPoint& point) { return point.at == at; });
    };
    CHECK(is_drawn({-32768, 32767}));
    CHECK(is_drawn({32767, 32767}));
    CHECK(is_drawn({32767, -32768}));
    CHECK(points.size() == stage.player.report().points);
}

}
