#include "tests/host/lottie/lottie_text.hpp"

#include "host/art/document/document.hpp"

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

using namespace kfast;
using namespace kfast::lottie;

namespace {

art::Transform transform(const std::string& ks, const std::string& more = "")
{
    return read_whole(animation_text(solid("\"ks\": {" + ks + "}, " + more))).nodes.at(0).transform;
}

/// As Lottie has it, computed apart: x to the right, y down.
scene::Vec2 lottie_spot(scene::Vec2 spot, double scale_x, double scale_y, double skew, double axis,
                        double turn)
{
    constexpr double degree = std::numbers::pi / 180;
    const auto rotated = [](scene::Vec2 s, double angle) {
        return scene::Vec2{s.x * std::cos(angle) - s.y * std::sin(angle),
                           s.x * std::sin(angle) + s.y * std::cos(angle)};
    };
    spot = {spot.x * scale_x, spot.y * scale_y};
    spot = rotated(spot, axis * degree);
    spot = {spot.x - std::tan(skew * degree) * spot.y, spot.y};
    spot = rotated(spot, -axis * degree);
    return rotated(spot, turn * degree);
}

}

TEST_CASE("a transform has its anchor, position, scale and turn")
{
    const art::Transform result =
        transform(R"("a": {"k": [1, 2, 0]}, "p": {"k": [3, 4, 0]}, "s": {"k": [50, -25, 100]},
        "r": {"k": 90}, "sk": {"k": 0}, "sa": {"k": 45})");
    CHECK(result.anchor_x.value() == 1);
    CHECK(result.anchor_y.value() == 2);
    CHECK(result.x.value() == 3);
    CHECK(result.y.value() == 4);
    CHECK(result.scale_x.value() == 0.5);
    CHECK(result.scale_y.value() == -0.25);
    CHECK(result.rotate.value() == 90);
}

TEST_CASE("a split position has each axis with its own keys")
{
    const art::Transform result = transform(
        R"("p": {"s": true, "x": {"a": 1, "k": [{"t": 0, "s": [1]}, {"t": 9, "s": [5]}]}, "y": {"k": 7}})");
    CHECK(result.x.keys.size() == 2);
    CHECK(result.x.keys[1].time == 9);
    CHECK(result.y.value() == 7);
    CHECK_FALSE(result.path);
}

TEST_CASE("a position without tangents has eases of its own for each axis")
{
    const art::Transform result =
        transform(R"("p": {"a": 1, "k": [{"t": 0, "s": [0, 0], "to": [0, 0], "ti": [0, 0],
        "o": {"x": [0.3, 0.2], "y": [0, 0]}, "i": {"x": [0.7, 0.9], "y": [1, 1]}}, {"t": 10, "s": [9, 9]}]})");
    CHECK_FALSE(result.path);
    CHECK(result.x.keys[0].ease.x1 == 0.3);
    CHECK(result.y.keys[0].ease.x2 == 0.9);
}

TEST_CASE("a position with tangents is a path, and its keys are shares of the length")
{
    const art::Transform result = transform(R"("p": {"a": 1, "k": [
        {"t": 0, "s": [0, 0], "to": [0, -30], "ti": [0, -30], "o": {"x": 0.4, "y": 0}, "i": {"x": 0.6, "y": 1}},
        {"t": 10, "s": [40, 0], "h": 1}, {"t": 20, "s": [40, 40]}, {"t": 30, "s": [0, 40]}]})");
    REQUIRE(result.path);
    const scene::Outline& outline = result.path->path.outlines.at(0);
    REQUIRE(outline.curves.size() == 3);
    CHECK(outline.curves[0].cubic);
    CHECK(outline.curves[0].c1.y == -30);
    CHECK(outline.curves[0].c2.x == 40);
    CHECK_FALSE(outline.curves[1].cubic);
    const auto& keys = result.path->share.keys;
    REQUIRE(keys.size() == 4);
    CHECK(keys[0].value == 0);
    CHECK(keys[0].ease == art::Ease{art::EaseKind::cubic, 0.4, 0, 0.6, 1});
    CHECK(keys[1].ease.kind == art::EaseKind::hold);
    CHECK(keys[3].value == 1);
    // The curve is as long as a parabola of that height: computed by 100,000 chords.
    double length = 0;
    scene::Vec2 at;
    for (int i = 1; i <= 100'000; ++i) {
        const double t = i / 100'000.0;
        const scene::Vec2 next{40 * t * t * (3 - 2 * t), -90 * t * (1 - t)};
        length += distance(at, next);
        at = next;
    }
    CHECK(keys[1].value == doctest::Approx(length / (length + 80)).epsilon(1e-6));
    CHECK(keys[2].value == doctest::Approx((length + 40) / (length + 80)).epsilon(1e-6));
}

TEST_CASE("a position with tangents that lie on the way from key to key is straight")
{
    const auto has_path = [](const std::string& tangents, const std::string& end) {
        return transform(R"("p": {"a": 1, "k": [{"t": 0, "s": [2, 0], )" + tangents +
                         R"(, "o": {"x": 0.4, "y": 0}, "i": {"x": 0.6, "y": 1}}, {"t": 10, "s": )" + end +
                         "}]}")
            .path.has_value();
    };
    CHECK_FALSE(has_path(R"("to": [2.1667, 0], "ti": [-2.1667, 0])", "[15, 0]"));
    CHECK_FALSE(has_path(R"("to": [3.333, 1.667], "ti": [-3.333, -1.667])", "[12, 5]"));
    CHECK_FALSE(has_path(R"("to": [0, 0], "ti": [0, 0])", "[2, 0]"));
    CHECK(has_path(R"("to": [2, 0.1], "ti": [-2, 0])", "[15, 0]"));
    CHECK(has_path(R"("to": [-2, 0], "ti": [-2, 0])", "[15, 0]")); // first back, then forth
    CHECK(has_path(R"("to": [5, 0], "ti": [5, 0])", "[2, 0]"));    // forth and back
}

TEST_CASE("a layer that points along its path has one, straight or not")
{
    const char* const moving = R"("p": {"a": 1, "k": [{"t": 0, "s": [0, 0]}, {"t": 10, "s": [0, 40]}]})";
    CHECK_FALSE(transform(moving).path);
    const art::Transform turning = transform(moving, R"("ao": 1, )");
    REQUIRE(turning.path);
    CHECK(turning.path->turns);
    CHECK_FALSE(transform(R"("p": {"k": [1, 2]})", R"("ao": 1, )").path);
    art::Losses losses;
    read_with(animation_text(
                  solid(R"("ao": 1, "ks": {"p": {"s": true, "x": {"k": [{"t": 0, "s": 1}, {"t": 9, "s": 5}]},
        "y": {"k": 7}}}, )")),
              losses);
    REQUIRE(losses.list().size() == 1);
    CHECK(losses.list()[0].feature == "orientation along a split position");
    CHECK(matrix_at(turning, 5).of(scene::Vec2{1, 0}).y == doctest::Approx(21));
}

TEST_CASE("a layer leans as in Lottie, also where its scales differ")
{
    const art::Transform result =
        transform(R"("s": {"k": [200, 50]}, "sk": {"k": 30}, "sa": {"k": 20}, "r": {"k": 10})");
    for (const scene::Vec2 spot : {scene::Vec2{1, 0}, scene::Vec2{0, 1}}) {
        const scene::Vec2 expected = lottie_spot(spot, 2, 0.5, 30, 20, 10);
        CHECK(matrix_at(result, 0).of(spot).x == doctest::Approx(expected.x));
        CHECK(matrix_at(result, 0).of(spot).y == doctest::Approx(expected.y));
    }
}

TEST_CASE("a layer leans as in Lottie while its scales, its turn and its lean change")
{
    const art::Transform result =
        transform(R"("s": {"k": [{"t": 0, "s": [100, 100]}, {"t": 10, "s": [200, 50]}]},
        "sk": {"k": [{"t": 0, "s": 0}, {"t": 20, "s": 40}]}, "r": {"k": [{"t": 5, "s": 0}, {"t": 20, "s": 60}]})");
    for (const double time : {0.0, 2.5, 8.0, 15.0, 20.0}) {
        const double scale_factor = std::min(time / 10, 1.0);
        const double turn = time < 5 ? 0 : (time - 5) * 4;
        const scene::Vec2 expected =
            lottie_spot({10, 10}, 1 + scale_factor, 1 - scale_factor / 2, time * 2, 0, turn);
        CHECK(matrix_at(result, time).of(scene::Vec2{10, 10}).x ==
              doctest::Approx(expected.x).epsilon(0.002));
        CHECK(matrix_at(result, time).of(scene::Vec2{10, 10}).y ==
              doctest::Approx(expected.y).epsilon(0.002));
    }
}

TEST_CASE("turns in space are those of After Effects, where z leads away")
{
    const std::string ks = R"("p": {"k": [1, 2, 30]}, "rx": {"k": 10}, "ry": {"k": 20}, "rz": {"k": 40})";
    const art::Transform result = transform(ks, R"("ddd": 1, )");
    CHECK(result.z.value() == -30);
    CHECK(result.rotate_x.value() == -10);
    CHECK(result.rotate_y.value() == -20);
    CHECK(result.rotate.value() == 40);
    const art::Transform oriented =
        transform(R"("or": {"k": [10, 20, 30]}, "rz": {"k": 5})", R"("ddd": 1, )");
    CHECK(oriented.rotate_x.value() == -10);
    CHECK(oriented.rotate_y.value() == -20);
    CHECK(oriented.rotate.value() == 35);
    CHECK(transform(ks).rotate_x.value() == 0);
}

TEST_CASE("an orientation and turns that are not one turn about each axis are reported")
{
    art::Losses losses;
    const art::Document document = read_with(
        animation_text(solid(R"("ddd": 1, "ks": {"or": {"k": [0, 0, 30]}, "rx": {"k": 5}}, )")), losses);
    REQUIRE(losses.list().size() == 1);
    CHECK(losses.list()[0].layer == "box");
    CHECK(document.nodes[0].transform.rotate_x.value() == -5);
}

TEST_CASE("a camera that looks straight at the canvas is a distance, others are reported")
{
    const auto camera = [](const std::string& ks) {
        return animation_text(R"({"ty": 13, "nm": "view", "pe": 300, "ks": {)" + ks + "}}");
    };
    CHECK(read_whole(camera(R"("p": {"k": [50, 40, -300]}, "a": {"k": [50, 40, 0]})")).camera == 300.0);
    art::Losses losses;
    CHECK(read_with(camera(R"("p": {"k": [90, 40, -300]}, "a": {"k": [50, 40, 0]})"), losses).camera ==
          300.0);
    REQUIRE(losses.list().size() == 1);
    CHECK(losses.list()[0].feature == "camera");
}
