#include "core/pose/posed_bones.hpp"

#include "tests/core/array_drawing.hpp"
#include "tests/core/pose/exact_bones.hpp"
#include "tests/core/pose/random_skeleton.hpp"
#include "tests/core/puppet.hpp"
#include "tests/core/raw_bones.hpp"
#include "tests/core/spot.hpp"
#include "tests/rounds.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

using namespace of_bone;

Point random_point_around(std::mt19937& random, const ExactBone& bone)
{
    const auto near = [&random](double middle) { return std::floor(middle) + within(random, -100, 100); };
    return pixels(near(bone.rest.origin.x), near(bone.rest.origin.y));
}

/// Of the points that the bones carry, and of their origins.
double worst_error(const RawSkeleton& skeleton, const std::vector<PosedBone>& live, Time time,
                   std::mt19937& random)
{
    const std::vector<ExactBone> exact = exact_bones(skeleton, time);
    double worst = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        worst = std::max(worst, apart(live[i].frame().origin, exact[i].posed.origin));
        for (int round = 0; round < 4; ++round) {
            const Point point = random_point_around(random, exact[i]);
            worst = std::max(worst, apart(live[i](point), spot(point) * exact[i].map()));
        }
    }
    return worst;
}

double worst_error(std::mt19937& random, Turns turns)
{
    double worst = 0;
    for (int round = 0; round < rounds(3000); ++round) {
        const RawSkeleton skeleton = random_skeleton(random, turns);
        Puppet puppet{{skeleton}};
        for (int moment = 0; moment < 4; ++moment) {
            const Time time{within(random, 0, 10 * 1024)};
            worst = std::max(worst, worst_error(skeleton, puppet.at(time), time, random));
        }
    }
    return worst;
}

/// What becomes of a point at `at` with one bone that turns from `from` to `to` in two frames.
Point deformed(std::int32_t from, std::int32_t to, bool as_written, Time time, Point at)
{
    RawBone bone{.turns_as_written = as_written};
    bone.keys[angle].own = {{{}, 0, from}, {Time::frame(2), 0, to}};
    Puppet puppet{{{{}, {bone}}}};
    return puppet.at(time)[0](at);
}

}

TEST_CASE("bones in their set-up leave every point exactly where it is")
{
    std::mt19937 random{71};
    for (int round = 0; round < rounds(500); ++round) {
        RawSkeleton skeleton = random_skeleton(random);
        for (RawBone& bone : skeleton.bones)
            for (std::size_t quantity = 0; quantity < 4; ++quantity) {
                RawBoneKeys& keys = bone.keys[quantity];
                std::ranges::fill(keys.common, bone.set_up[quantity]);
                for (RawTrackKey& key : keys.own)
                    key.value = bone.set_up[quantity];
            }
        Puppet puppet{{skeleton}};
        const Point point = pixels(within(random, -2047, 2047), within(random, -2047, 2047));
        for (const PosedBone& bone : puppet.at({within(random, 0, 10 * 1024)}))
            REQUIRE(bone(point) == point);
    }
}

TEST_CASE("any tree of bones is within 1/32 px of the exact one at any time")
{
    std::mt19937 random{72};
    const double worst = worst_error(random, Turns::shortest);
    CHECK(worst <= 1.0 / 32);
}

TEST_CASE("any tree of bones that turn up to twice is within 1/16 px of the exact one at any time")
{
    std::mt19937 random{74};
    const double worst = worst_error(random, Turns::as_written);
    CHECK(worst <= 1.0 / 16);
}

TEST_CASE("several skeletons lie one after the other, and what was shown before does not matter")
{
    std::mt19937 random{73};
    for (int round = 0; round < rounds(100); ++round) {
        const std::vector<RawSkeleton> skeletons{random_skeleton(random), random_skeleton(random),
                                                 random_skeleton(random)};
        Puppet together{skeletons};
        const Time time{within(random, 0, 10 * 1024)};
        together.at({within(random, 0, 10 * 1024)});
        std::size_t number = 0;
        for (const RawSkeleton& skeleton : skeletons) {
            Puppet alone{{skeleton}};
            for (const PosedBone& bone : alone.at(time)) {
                const Point point = pixels(within(random, 0, 512), within(random, 0, 512));
                REQUIRE(together.at(time)[number++](point) == bone(point));
            }
        }
    }
}

TEST_CASE("angles take the shortest way, just half a turn against the clock")
{
    const auto half_way = [](std::int32_t from, std::int32_t to) {
        return deformed(from, to, false, Time::frame(1), pixels(100, 0));
    };
    CHECK(half_way(0, 32767).y > Fixed::pixels(99));
    CHECK(half_way(0, 32768) == pixels(0, -100));
    CHECK(half_way(32768, 0) ==
          pixels(0, 100)); // from the left by the upper half turn to the right: no, lower
    CHECK(half_way(0, 32769).y < Fixed::pixels(-99));
    CHECK(half_way(65536 - 8192, 8192) == pixels(100, 0));
    CHECK(half_way(8192, 65536 - 8192) == pixels(100, 0));
}

TEST_CASE("keys of the shortest way count modulo one turn")
{
    CHECK(deformed(5 * 65536, -3 * 65536 + 16384, false, Time::frame(1), pixels(64, 0)) ==
          deformed(0, 16384, false, Time::frame(1), pixels(64, 0)));
}

TEST_CASE("angles as written make all of their turns")
{
    const auto at = [](int ticks) { return deformed(0, -16 * 65536, true, {ticks}, pixels(100, 0)); };
    CHECK(at(1024) == pixels(100, 0)); // 8 turns
    CHECK(at(32) == pixels(0, -100));  // a quarter of one
    CHECK(at(64) == pixels(-100, 0));
    CHECK(deformed(0, 32768, true, Time::frame(1), pixels(100, 0)) == pixels(0, 100));
}

TEST_CASE("a child at the tip moves with the length of its parent, any other stays")
{
    RawBone parent{.set_up = {16384, 160, 0, 320}};
    parent.keys[length].own = {{{}, 0, 320}, {Time::frame(2), 0, 960}};
    const RawBone at_tip{.parent = 1, .is_at_tip = true, .set_up = {0, 320, 0, 160}};
    const RawBone beside{.parent = 1, .set_up = {0, 320, 0, 160}};
    const RawBone grandchild{.parent = 2, .is_at_tip = true, .set_up = {0, 160, 0, 160}};
    Puppet puppet{{{{}, {parent, at_tip, beside, grandchild}}}};
    const auto& bones = puppet.at(Time::frame(1));
    CHECK(bones[0].frame().origin == pixels(10, 0));
    CHECK(bones[1].frame().origin == pixels(10, 40));
    CHECK(bones[2].frame().origin == pixels(10, 20));
    CHECK(bones[3].frame().origin == pixels(10, 50));
    CHECK(bones[0](pixels(13, 10)) == pixels(13, 20)); // stretched along, not across
    CHECK(bones[1](pixels(13, 25)) == pixels(13, 45)); // its parent's stretch is not its own
}

TEST_CASE("a bone that is drawn together to no length draws its points onto the line across it")
{
    RawBone bone{.set_up = {0, 160, 160, 320}};
    bone.keys[length].own = {{{}, 0, 0}};
    Puppet puppet{{{{}, {bone}}}};
    CHECK(puppet.at({})[0](pixels(25, 17)) == pixels(10, 17));
    CHECK(puppet.at({})[0](pixels(0, 5)) == pixels(10, 5));
}

TEST_CASE("a length is never below 0, and no bone stretches more than 64 times")
{
    RawBone swinging{.set_up = {0, 0, 0, 160}};
    swinging.keys[length].own = {{{}, Puppet::wild, 160}, {Time::frame(10), 0, 0}};
    RawBone long_one{.set_up = {0, 0, 0, 1}};
    long_one.keys[length].own = {{{}, 0, 65535}};
    Puppet puppet{{{{}, {swinging, long_one}}}};
    CHECK(puppet.at(Time::frame(9))[0](pixels(7, 3)) == pixels(0, 3));
    CHECK(puppet.at({})[1](pixels(2, 3)) == pixels(128, 3));
}

TEST_CASE("x, angle and length go by the law for x, y by that for y")
{
    RawBone bone{.set_up = {0, 0, 0, 160}};
    constexpr int hold_accelerate = 3;
    for (std::size_t quantity = 0; quantity < 4; ++quantity)
        bone.keys[quantity].common = {0, 160};
    Puppet puppet{{{{{{}, hold_accelerate}, {Time::frame(2), 0}}, {bone}}}};
    const auto& bones = puppet.at(Time::frame(1));
    CHECK(bones[0].frame().origin.x == Fixed{});
    CHECK(apart(bones[0].frame().origin, {0, 10 - 5 * std::numbers::sqrt2}) < 0.001);
    CHECK(bones[0].frame().angle == FineAngle{});
    CHECK(bones[0](pixels(5, 0)).x == Fixed{}); // of no length
}

TEST_CASE("values far outside of the canvas are held, not wrapped")
{
    RawSkeleton skeleton;
    for (int parent = 0; parent < 30; ++parent) {
        RawBone bone{.parent = parent, .set_up = {0, 32767, -32768, 65535}};
        bone.keys[angle].own = {{{}, Puppet::wild, 1}, {Time::frame(10), 0, 65535}};
        bone.keys[x].own = {{{}, Puppet::wild, 32767}, {Time::frame(10), 0, -32768}};
        bone.keys[y].own = {{{}, Puppet::wild, -32768}, {Time::frame(10), 0, 32767}};
        bone.keys[length].own = {{{}, Puppet::wild, 0}, {Time::frame(10), 0, 65535}};
        bone.is_at_tip = parent > 15;
        skeleton.bones.push_back(bone);
    }
    Puppet puppet{{skeleton}};
    for (int frame = 0; frame <= 10; ++frame)
        for (const PosedBone& bone : puppet.at(Time::frame(frame)))
            for (const Point point : {pixels(-2048, 2047), pixels(2047, -2048)}) {
                const Point to = bone(point);
                for (const Fixed side : {to.x, to.y, bone.frame().origin.x, bone.frame().origin.y})
                    CHECK(std::abs(side.raw()) <= Fixed::pixels(16383).raw());
            }
}

}
