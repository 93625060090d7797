#include "core/features.hpp"
#include "core/pose/posed_bones.hpp"
#include "core/time/track.hpp"
#include "host/scene/skeleton/bone_frames.hpp"
#include "tests/core/moved_scene.hpp"
#include "tests/core/player_fixture.hpp"
#include "tests/host/compiler/posed_drawing.hpp"
#include "tests/host/compiler/random_scene.hpp"
#include "tests/host/compiler/scene_parts.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

/// What the compiler foresees of bones in motion, against what the player makes of them.
namespace kfast::test {
namespace {

/// The bones of a compiled scene's first skeleton, and the first object that they carry.
class Played {
public:
    explicit Played(const SceneView& scene)
        : scene_{scene}, object_{scene.items().next().object}, moved_{scene}
    {
    }

    /// Both ends of the way that is under way, and how far it has come.
    struct Moment {
        Key from;
        Key to;
        ProgressXY progress;
    };

    Moment at(Time time)
    {
        bones_ = moved_.bones_at(time);
        const auto [from, to] = interval_at(object_.keys(), time);
        return {from, to, progress_between(from.time, to.time, time, scene_.laws(from.laws), &kfast_springs)};
    }

    DeformedDrawing drawing(const Key& key) const
    {
        const SkinReader skin = scene_.skin(key.more);
        const PackedDrawing drawing = scene_.drawing(key.drawing);
        return {drawing, skin.has_drawing_at_rest() ? scene_.drawing(skin.drawing_at_rest()) : drawing, skin,
                bones_};
    }

private:
    const SceneView& scene_;
    ObjectView object_;
    MovedScene moved_;
    std::span<const PosedBone> bones_;
};

double pixels(Fixed value) { return static_cast<double>(value.raw()) / Fixed::one; }

double distance(Point a, Point b)
{
    return std::max(std::abs(pixels(a.x - b.x)), std::abs(pixels(a.y - b.y)));
}

double worst_difference(DeformedDrawing played, const PosedDrawing& posed)
{
    double worst = 0;
    for (const PosedDrawing::Stroke& stroke : posed.strokes()) {
        REQUIRE(played.next_stroke() == stroke.segments.size());
        worst = std::max(worst, distance(played.start(), stroke.start));
        for (const Segment& segment : stroke.segments) {
            const Segment other = played.next_segment();
            for (Point Segment::*point : {&Segment::from, &Segment::c1, &Segment::c2, &Segment::to})
                worst = std::max(worst, distance(segment.*point, other.*point));
        }
    }
    return worst;
}

std::vector<scene::BoneMotion> motions_at(const scene::Bones& skeleton, Time time)
{
    const auto set_up = scene::frames_as_set_up(skeleton.bones);
    const auto posed = scene::frames_at(skeleton.bones, time);
    std::vector<scene::BoneMotion> motions;
    for (std::size_t i = 0; i < posed.size(); ++i)
        motions.emplace_back(set_up[i], posed[i]);
    return motions;
}

Time some_time(std::mt19937& random) { return {static_cast<std::int32_t>(random() % (40 * 1024 + 1))}; }

}

TEST_CASE("the player carries points to where the compiler foresees them")
{
    std::mt19937 random{41};
    for (int round = 0; round < 200; ++round) {
        const scene::Scene scene = random_deformed_scene(random);
        const std::vector<std::byte> bytes = written(scene);
        const auto view = SceneView::parse(bytes);
        REQUIRE(view);
        Played played{*view};
        const scene::Object& object = std::get<scene::Object>(scene.items[0].content);
        const auto first =
            skinned_drawing(object.keys[0].drawing, object.skin->bindings, object.keys[0].drawing);
        for (int moment = 0; moment < 20; ++moment) {
            const Time time = some_time(random);
            const auto [from, to, progress] = played.at(time);
            if (from.time == object.keys[0].time)
                CHECK(worst_difference(played.drawing(from),
                                       PosedDrawing{*first, motions_at(scene.bones[0], time)}) < 1.0 / 32);
        }
    }
}

TEST_CASE("what drawings change stays as it is on the canvas, or turns with the bones")
{
    const auto eye = [](const std::string& properties, const std::string& keys) {
        return PlayerFixture{
            "kfast 1\ncanvas 90 90 loop=once\nbones b { bone head 20 45 45 45; pose 0 { head turn=90 } }\n"
            "object eye fill=white skin=b bone=head" +
                properties + " {" + keys + "}",
            {90, 90}}
            .picture(Time::frame(10));
    };
    const std::string wide = "rect 30 30 16 30";
    const std::string narrow = "rect 30 40 16 10";
    const std::string closing = "key 0 {" + wide + "}; key 10 {" + narrow + "}";
    CHECK(eye(" change=bones", closing) == eye("", narrow));
    CHECK(eye("", closing) != eye("", narrow));
    CHECK(eye("", closing) == eye(" change=canvas", closing));
    // It leans instead of closing, as docs/scene-language.md says: what is shorn keeps its area.
    const auto lit = [](const auto& picture) {
        return std::ranges::count_if(picture, [](auto value) { return value != decltype(value){}; });
    };
    CHECK(lit(eye("", closing)) > lit(eye("", wide)) * 9 / 10);
    CHECK(lit(eye(" change=bones", closing)) < lit(eye("", wide)) / 2);
}

}
