#include "host/compiler/carry/deformed_tweens.hpp"

#include "core/player.hpp"
#include "host/compiler/carry/backbone_timeline.hpp"
#include "host/compiler/compile.hpp"
#include "host/compiler/write/key_writer.hpp"
#include "host/geometry/outline.hpp"
#include "tests/host/compiler/backbone_parts.hpp"
#include "tests/host/compiler/scene_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <doctest/doctest.h>
#include <random>
#include <string>

namespace kfast::test {
namespace {

using scene::Vec2;

struct Deformed {
    KeyTweens tweens;
    std::vector<Diagnostic> findings;
};

Deformed deform(const scene::Object& object)
{
    Diagnostics diagnostics;
    KeyTweens tweens = key_tweens(object, diagnostics);
    return {std::move(tweens), diagnostics.sorted()};
}

/// The vertices of a stroke as they are stored.
std::vector<scene::Point> vertices(const scene::Stroke& stroke)
{
    std::vector<scene::Point> points{stroke.from};
    for (const scene::Segment& segment : stroke.segments)
        points.push_back(segment.to);
    return points;
}

/// Where the backbones of `object` put what is stored, in pixels.
std::vector<std::vector<Vec2>> placed(const scene::Object& object, const scene::Drawing& stored,
                                      std::uint32_t unit_bits, Time time)
{
    const BackboneTimeline backbones{object.backbone_keys};
    std::vector<BackboneNode> nodes(backbones.node_count());
    const PosedBackbones live = backbones.at(time, unit_bits, nodes);
    const auto spot = [&live](scene::Point point) {
        const Point at = live.place({Fixed::sixteenths(point.x), Fixed::sixteenths(point.y)});
        return Vec2{at.x.raw() / 65536.0, at.y.raw() / 65536.0};
    };
    std::vector<std::vector<Vec2>> strokes;
    for (const scene::Stroke& stroke : stored.strokes) {
        std::vector<Vec2>& spots = strokes.emplace_back();
        for (const scene::Point point : vertices(stroke))
            spots.push_back(spot(point));
        for (const scene::Segment& segment : stroke.segments)
            if (segment.cubic) {
                spots.push_back(spot(segment.c1));
                spots.push_back(spot(segment.c2));
            }
    }
    return strokes;
}

double distance_to(const std::vector<Vec2>& spots, scene::Point point)
{
    double min = 1e9;
    for (const Vec2 spot : spots)
        min = std::min(min, std::hypot(spot.x - point.x / 16.0, spot.y - point.y / 16.0));
    return min;
}

/// A band that wanders, with outlines of its own, and points in its cells.
class RandomBand {
public:
    scene::Backbone backbone(int nodes)
    {
        scene::Backbone backbone;
        double x = 1200;
        double y = 1200;
        double direction = number(0, 6);
        for (; nodes > 0; --nodes) {
            backbone.nodes.push_back(point(x, y));
            const double width = number(60, 160);
            backbone.left.push_back(point(x + width * std::sin(direction), y - width * std::cos(direction)));
            backbone.right.push_back(point(x - width * std::sin(direction), y + width * std::cos(direction)));
            x += 320 * std::cos(direction);
            y += 320 * std::sin(direction);
            direction += number(-0.4, 0.4);
        }
        return backbone;
    }

    scene::Point in_cell(const scene::Backbone& backbone)
    {
        const auto i =
            static_cast<std::size_t>(number(0, static_cast<double>(backbone.nodes.size()) - 1.001));
        const auto& side = number(0, 2) < 1 ? backbone.left : backbone.right;
        const double along = number(0, 1);
        const double across = number(0, 1);
        const auto at = [&](std::int16_t scene::Point::*axis) {
            const double middle = std::lerp(backbone.nodes[i].*axis, backbone.nodes[i + 1].*axis, along);
            return std::lerp(middle, std::lerp(side[i].*axis, side[i + 1].*axis, along), across);
        };
        return point(at(&scene::Point::x), at(&scene::Point::y));
    }

    double number(double min, double max)
    {
        return min + (max - min) * static_cast<double>(random_()) / 4294967296.0;
    }

private:
    static scene::Point point(double x, double y)
    {
        return {static_cast<std::int16_t>(std::lround(x)), static_cast<std::int16_t>(std::lround(y))};
    }

    std::mt19937 random_{77};
};

const scene::Drawing bar = lines({{176, 400}, {448, 400}, {448, 560}, {176, 560}, {176, 400}});

}

TEST_CASE("a drawing is as it was drawn where its skeleton is as it was")
{
    RandomBand random;
    for (int round = 0; round < 200; ++round) {
        const int nodes = 2 + round % 7;
        const scene::Backbone backbone = random.backbone(nodes);
        scene::Stroke stroke{.from = random.in_cell(backbone), .segments = {}};
        for (int i = 0; i < 8; ++i)
            stroke.segments.push_back(
                {i % 2 == 0, random.in_cell(backbone), random.in_cell(backbone), random.in_cell(backbone)});
        const scene::Object object = deformed(
            filled({key(0, {{stroke}})}), {skeleton(0, {backbone}), skeleton(9, {random.backbone(nodes)})});
        const auto [deformed, findings] = deform(object);
        CHECK(findings.empty());
        const auto spots = placed(object, deformed.tweens[0].ends.from, deformed.unit_bits, {});
        for (const scene::Point point : vertices(stroke))
            CHECK(distance_to(spots[0], point) < 1.0 / 16);
    }
}

TEST_CASE("a drawing between two skeletons is bound to the one of that moment")
{
    const scene::Object object =
        deformed(filled({key(5, bar)}), {skeleton(0, {moved(straight_band(2), 0, -160)}),
                                         skeleton(10, {moved(straight_band(2), 0, 160)})});
    const auto [deformed, findings] = deform(object);
    CHECK(findings.empty());
    for (const scene::Point point : vertices(bar.strokes[0])) {
        CHECK(distance_to(placed(object, deformed.tweens[0].ends.from, deformed.unit_bits, Time::frame(5))[0],
                          point) < 1.0 / 32);
        const scene::Point below{point.x, static_cast<std::int16_t>(point.y + 160)};
        CHECK(
            distance_to(placed(object, deformed.tweens[0].ends.from, deformed.unit_bits, Time::frame(10))[0],
                        below) < 1.0 / 32);
    }
}

TEST_CASE("the unit is the finest that all points fit in")
{
    const auto bits = [](const scene::Drawing& drawing, int segments) {
        return deform(deformed(filled({key(0, drawing)}), {skeleton(0, {straight_band(segments)})}))
            .tweens.unit_bits;
    };
    CHECK(bits(lines({{176, 470}, {300, 490}}), 1) == 15);
    CHECK(bits(bar, 2) == 14);
    CHECK(bits(bar, 40) == 14); // it lies at the beginning
    CHECK(bits(lines({{176, 480}, {160 * 40, 480}}), 40) == 9);
    CHECK(bits(lines({{176, 480}, {176, 480 + 7 * 160}}), 2) == 12);
}

TEST_CASE("lines are divided where they pass from one segment to the next")
{
    const scene::Object object =
        deformed(stroked(16, {key(0, lines({{176, 480}, {560, 400}}))}), {skeleton(0, {straight_band(3)})});
    const auto [deformed, findings] = deform(object);
    const scene::Stroke& stroke = deformed.tweens[0].ends.from.strokes[0];
    REQUIRE(stroke.segments.size() == 3);
    CHECK(stroke.segments[0].to.x == 1 << deformed.unit_bits);
    CHECK(stroke.segments[1].to.x == 2 << deformed.unit_bits);
    CHECK(deform(test::deformed(stroked(16, {key(0, lines({{176, 480}, {300, 400}}))}),
                                {skeleton(0, {straight_band(3)})}))
              .tweens.tweens[0]
              .ends.from.strokes[0]
              .segments.size() == 1);
}

TEST_CASE("curves that pass a node are divided in the middle of segments")
{
    const auto along = [](const scene::Drawing& drawing) {
        const auto [deformed, findings] =
            deform(test::deformed(stroked(16, {key(0, drawing)}), {skeleton(0, {straight_band(3)})}));
        std::vector<double> places;
        for (const scene::Segment& segment : deformed.tweens[0].ends.from.strokes[0].segments)
            places.push_back(std::round(segment.to.x * 100.0 / (1 << deformed.unit_bits)) / 100);
        return places;
    };
    CHECK(along(curve({160, 480}, {320, 400}, {480, 400}, {640, 480})) == std::vector{0.5, 1.5, 2.5, 3.0});
    CHECK(along(curve({160, 480}, {200, 400}, {260, 400}, {310, 480})) == std::vector{0.94});
}

TEST_CASE("both drawings of a way are divided alike, each where it crosses the same border")
{
    const scene::Object object =
        deformed(stroked(16, {key(0, lines({{176, 480}, {560, 480}})),
                              key(10, lines({{200, 480}, {600, 400}})), key(20, bar)}),
                 {skeleton(0, {straight_band(3)})});
    const auto [deformed, findings] = deform(object);
    REQUIRE(deformed.tweens.size() == 3);
    for (const scene::Drawing* end : {&deformed.tweens[0].ends.from, &deformed.tweens[0].ends.to}) {
        REQUIRE(end->strokes[0].segments.size() == 3);
        CHECK(end->strokes[0].segments[0].to.x == 1 << deformed.unit_bits);
        CHECK(end->strokes[0].segments[1].to.x == 2 << deformed.unit_bits);
    }
    const MatchedDrawings& other = deformed.tweens[1].ends;
    CHECK(other.from.strokes[0].segments.size() > 4);
    CHECK(other.from.strokes[0].segments.size() == other.to.strokes[0].segments.size());
}

TEST_CASE("an empty drawing grows from the centre, and shows nothing on its own key")
{
    const std::vector<scene::Key> keys{key(0, {}), key(10, bar), key(20, {})};
    const auto filled_tweens = deform(deformed(filled(keys), {skeleton(0, {straight_band(2)})})).tweens;
    REQUIRE(filled_tweens.tweens.size() == 3);
    const scene::Stroke& centre = filled_tweens.tweens[0].ends.from.strokes[0];
    for (const scene::Point point : vertices(centre))
        CHECK(point == centre.from);
    CHECK(std::abs(centre.from.y) <= 1);
    CHECK(filled_tweens.tweens[2].ends.from.strokes.empty());
    const auto stroked_tweens = deform(deformed(stroked(16, keys), {skeleton(0, {straight_band(2)})})).tweens;
    REQUIRE(stroked_tweens.tweens.size() == 4);
    CHECK(stroked_tweens.tweens[0].ends.to.strokes.empty());
    CHECK(stroked_tweens.tweens[1].time == Time{1});
    CHECK(stroked_tweens.tweens[1].ends.from.strokes.size() == 1);
}

TEST_CASE("a drawing that holds is not matched with the next one")
{
    const LawPair hold{VelocityLaw::hold, VelocityLaw::hold};
    const auto tweens =
        deform(deformed(filled({key(0, {}, hold), key(10, bar)}), {skeleton(0, {straight_band(2)})}));
    CHECK(tweens.tweens.tweens[0].ends.from.strokes.empty());
    CHECK(tweens.tweens.tweens[0].ends.to.strokes.empty());
}

TEST_CASE("points outside of the skeleton are a warning at their key")
{
    scene::Object object = deformed(
        filled({key(0, lines({{160, 480}, {320, 640}, {320, 643}, {160, 736}, {100, 480}, {160, 480}}))}),
        {skeleton(0, {straight_band(2)})});
    object.keys[0].place = {12, 3};
    const Deformed near = deform(object);
    REQUIRE(near.findings.size() == 1);
    CHECK(near.findings[0].severity == Severity::warning);
    CHECK(near.findings[0].place.offset == 12);
    CHECK(near.findings[0].message ==
          "3 points of this drawing lie outside of the skeleton, the first at 20 40.1875");
    CHECK(near.findings[0].hint ==
          "make the skeleton wider or longer; until then, the nearest segment carries them");
    object.keys[0].drawing = lines({{160, 480}, {-200, 480}});
    CHECK(deform(object).findings[0].message ==
          "1 point of this drawing lies outside of the skeleton, the first at "
          "-12.5 30; 1 point had to be moved to its edge");
}

namespace {

/// The brightness of each pixel of a picture of a text scene, in levels of 255.
std::vector<int> picture(const std::string& text, int frame)
{
    Diagnostics diagnostics;
    const auto bytes = compile(SourceText{"test.kfast", text}, diagnostics);
    REQUIRE(bytes);
    const auto scene = SceneView::parse(*bytes);
    REQUIRE(scene);
    const Size panel = scene->canvas();
    std::vector<std::byte> block(Player::block_bytes(*scene, panel));
    auto player = Player::create(*scene, panel, Fit::contain, block);
    REQUIRE(player);
    player->show(Time::frame(frame));
    std::vector<std::byte> pixels(static_cast<std::size_t>(panel.width * panel.height) * 2);
    player->draw_rows<PixelFormat::rgb565>(panel.height, pixels);
    std::vector<int> levels;
    for (std::size_t i = 0; i < pixels.size(); i += 2) {
        const int both = static_cast<int>(pixels[i]) | static_cast<int>(pixels[i + 1]) << 8;
        levels.push_back((both >> 5 & 63) * 255 / 63);
    }
    return levels;
}

constexpr auto canvas = "kfast 1\ncanvas 96 64 loop=once frames=40\n";
constexpr auto shapes = "path \"M 12 30 C 20 14 50 20 60 28 L 84 30 L 80 44 C 60 40 40 50 14 40 Z\"";
constexpr auto other_shapes = "path \"M 20 24 L 80 28 L 70 46 Z\"; circle 40 34 r=6";

}

TEST_CASE("exactly on its key a drawing looks as it does without a skeleton")
{
    const std::string bent = "skeleton { backbone 10 30 34 34 60 32 88 40; width 40 }";
    const std::string straight = "skeleton { backbone 10 32 34 34 60 34 88 32; width 40 }";
    const std::string deformed =
        std::string{canvas} + "object o fill=white stroke=white width=3 {\n key 0 { " + shapes + "; " +
        straight + " }\n key 10 { " + bent + " }\n key 15 { " + other_shapes + "}\n key 20 { " + straight +
        " }\n key 30 { " + shapes + "; " + bent + " } }";
    const std::string plain = std::string{canvas} + "object o fill=white stroke=white width=3 {\n key 0 { " +
                              shapes + " }\n key 15 { " + other_shapes + " }\n key 30 { " + shapes + " } }";
    for (const int frame : {0, 15, 30, 40}) {
        const std::vector<int> with = picture(deformed, frame);
        const std::vector<int> without = picture(plain, frame);
        int worst = 0;
        for (std::size_t i = 0; i < with.size(); ++i)
            worst = std::max(worst, std::abs(with[i] - without[i]));
        CHECK(worst <= 24); // an edge may lie 1/16 px elsewhere, and is mixed in steps of 8
    }
    CHECK(picture(deformed, 7) != picture(plain, 7));
}

}
