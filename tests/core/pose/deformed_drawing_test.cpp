#include "core/pose/posed_bones.hpp"

#include "tests/core/array_drawing.hpp"
#include "tests/core/moved_scene.hpp"
#include "tests/core/raw_bones.hpp"
#include "tests/core/raw_drawing.hpp"
#include "tests/core/raw_skin.hpp"
#include "tests/core/spot.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

/// Four bones, each of which makes something else of a point.
class FourBones {
public:
    FourBones()
    {
        RawSkeleton skeleton;
        for (int number = 0; number < 4; ++number) {
            RawBone bone{.set_up = {4096 * number, 16 * 100, 16 * 50 * number, 16 * 40}};
            bone.keys[0].own = {{{}, 0, 9000 * number - 5000}};
            bone.keys[1].own = {{{}, 0, 16 * 120 - 300 * number}};
            bone.keys[3].own = {{{}, 0, 16 * 30 + 200 * number}};
            skeleton.bones.push_back(bone);
        }
        RawScene raw;
        raw.bones = skeleton_bytes(skeleton);
        const Bytes file = raw.file();
        const SceneView scene = *SceneView::parse(file);
        bones_ = MovedScene{scene}.bones_at({});
    }

    std::span<const PosedBone> all() const { return bones_; }

    Spot mix(Point point, const std::vector<RawInfluence>& shares) const
    {
        Spot sum{0, 0};
        for (const RawInfluence& share : shares)
            sum = sum + share.weight / 65536.0 * spot(bones_[static_cast<std::size_t>(share.bone)](point));
        return sum;
    }

private:
    std::vector<PosedBone> bones_;
};

Point in_pixels(scene::Point point) { return {Fixed::sixteenths(point.x), Fixed::sixteenths(point.y)}; }

/// For each point of its own; a run for each.
std::vector<RawRun> random_runs(std::mt19937& random, const scene::Drawing& drawing)
{
    std::vector<RawRun> runs(scene::point_count(drawing));
    for (RawRun& run : runs)
        run = {1, random_shares(random, 4)};
    return runs;
}

/// A drawing whose points move as those of `at_rest` would, and what it must look like.
struct Case {
    scene::Drawing drawing;
    scene::Drawing at_rest;
    std::vector<RawRun> runs;
};

/// How far any point is from p + (bones(r) - r), control points with the bones of their vertex.
double worst_error(const Case& it, DeformedDrawing deformed, const FourBones& bones)
{
    double worst = 0;
    const auto check = [&](Point is, scene::Point point, scene::Point rest, const RawRun& run) {
        const Spot moved = bones.mix(in_pixels(rest), run.shares) - spot(in_pixels(rest));
        worst = std::max(worst, apart(is, spot(in_pixels(point)) + moved));
    };
    auto run = it.runs.begin();
    REQUIRE(deformed.strokes() == it.drawing.strokes.size());
    for (std::size_t number = 0; number < it.drawing.strokes.size(); ++number) {
        const scene::Stroke& stroke = it.drawing.strokes[number];
        const scene::Stroke& rest = it.at_rest.strokes[number];
        REQUIRE(deformed.next_stroke() == stroke.segments.size());
        check(deformed.start(), stroke.from, rest.from, *run);
        Point end = deformed.start();
        for (std::size_t i = 0; i < stroke.segments.size(); ++i) {
            const Segment segment = deformed.next_segment();
            CHECK(segment.from == end);
            CHECK((segment.kind == Segment::Kind::cubic) == stroke.segments[i].cubic);
            if (stroke.segments[i].cubic) {
                check(segment.c1, stroke.segments[i].c1, rest.segments[i].c1, *run);
                check(segment.c2, stroke.segments[i].c2, rest.segments[i].c2, *(run + 1));
            }
            ++run;
            check(segment.to, stroke.segments[i].to, rest.segments[i].to, *run);
            end = segment.to;
        }
        ++run;
    }
    return worst;
}

}

TEST_CASE("without bones a drawing is as it was drawn")
{
    std::mt19937 random{82};
    const Bytes bytes = packed(random_drawing(random));
    PackedDrawing plain = drawing_at(bytes, 0);
    DeformedDrawing deformed{plain};
    REQUIRE(deformed.strokes() == plain.strokes());
    for (std::uint32_t stroke = 0; stroke < plain.strokes(); ++stroke) {
        const std::uint32_t segments = plain.next_stroke();
        REQUIRE(deformed.next_stroke() == segments);
        CHECK(deformed.start() == plain.start());
        for (std::uint32_t i = 0; i < segments; ++i)
            CHECK(deformed.next_segment() == plain.next_segment());
    }
}

TEST_CASE("points move as their bones say, weighted, and control points with their vertex")
{
    std::mt19937 random{83};
    const FourBones bones;
    double worst = 0;
    for (int round = 0; round < 1000; ++round) {
        const scene::Drawing drawing = random_drawing(random);
        const Case it{drawing, drawing, random_runs(random, drawing)};
        const Bytes drawing_bytes = packed(drawing);
        const Bytes skin = skin_bytes(it.runs);
        const PackedDrawing read = drawing_at(drawing_bytes, 0);
        const DeformedDrawing deformed{read, read, SkinReader{ByteReader{skin}}, bones.all()};
        worst = std::max(worst, worst_error(it, deformed, bones));
    }
    CHECK(worst < 2.0 / 65536);
}

TEST_CASE("a drawing with another at rest moves as that does, and keeps its distance from there")
{
    std::mt19937 random{84};
    const FourBones bones;
    double worst = 0;
    for (int round = 0; round < 1000; ++round) {
        const scene::Drawing at_rest = random_drawing(random);
        const Case it{random_drawing_like(at_rest, random), at_rest, random_runs(random, at_rest)};
        const Bytes drawing_bytes = packed(it.drawing);
        const Bytes rest_bytes = packed(at_rest);
        const Bytes skin = skin_bytes(it.runs, 1);
        const DeformedDrawing deformed{drawing_at(drawing_bytes, 0), drawing_at(rest_bytes, 0),
                                       SkinReader{ByteReader{skin}}, bones.all()};
        worst = std::max(worst, worst_error(it, deformed, bones));
    }
    CHECK(worst < 2.0 / 65536);
}

TEST_CASE("bones of equal weight carry a point to the mean of where each would")
{
    const FourBones bones;
    const scene::Drawing point{{polyline_of({{16 * 90, 16 * 30}})}};
    const Bytes bytes = packed(point);
    const Bytes skin = skin_bytes({{1, {{0, 16'384}, {1, 16'384}, {2, 16'384}, {3, 16'384}}}});
    const PackedDrawing read = drawing_at(bytes, 0);
    DeformedDrawing deformed{read, read, SkinReader{ByteReader{skin}}, bones.all()};
    deformed.next_stroke();
    Spot mean{0, 0};
    for (const PosedBone& bone : bones.all())
        mean = mean + 0.25 * spot(bone(pixels(90, 30)));
    CHECK(apart(deformed.start(), mean) < 1.0 / 65536);
}

TEST_CASE("a copy goes on reading from where the original stood")
{
    std::mt19937 random{85};
    const FourBones bones;
    const scene::Drawing drawing{{polyline_of({{0, 0}, {160, 0}, {160, 160}, {0, 160}})}};
    const Bytes bytes = packed(drawing);
    const Bytes skin = skin_bytes(random_runs(random, drawing));
    const PackedDrawing read = drawing_at(bytes, 0);
    DeformedDrawing deformed{read, read, SkinReader{ByteReader{skin}}, bones.all()};
    deformed.next_stroke();
    deformed.next_segment();
    DeformedDrawing copy = deformed;
    const Segment second = deformed.next_segment();
    const Segment third = deformed.next_segment();
    CHECK(copy.next_segment() == second);
    CHECK(copy.next_segment() == third);
    CHECK(second.to == third.from);
}

TEST_CASE("what bones carry out of reach is held within 4095 px")
{
    RawBone bone{.set_up = {0, 0, 0, 16}};
    bone.keys[3].own = {{{}, 0, 16 * 64}};
    RawScene raw;
    raw.bones = skeleton_bytes({{}, {bone}});
    const Bytes file = raw.file();
    const SceneView scene = *SceneView::parse(file);
    MovedScene moved{scene};
    const std::vector<PosedBone>& bones = moved.bones_at({});
    const Bytes bytes = packed({{polyline_of({{32767, 0}, {-32768, 16}})}});
    const Bytes skin = skin_bytes({{2, {{0}}}});
    const PackedDrawing read = drawing_at(bytes, 0);
    DeformedDrawing deformed{read, read, SkinReader{ByteReader{skin}}, bones};
    deformed.next_stroke();
    CHECK(deformed.start() == pixels(4095, 0));
    CHECK(deformed.next_segment().to == pixels(-4095, 1));
}

}
