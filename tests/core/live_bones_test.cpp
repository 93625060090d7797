#include "core/live_bones.hpp"

#include "tests/core/array_drawing.hpp"
#include "tests/core/exact_law.hpp"
#include "tests/core/raw_bones.hpp"
#include "tests/core/spot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

constexpr auto angle = static_cast<std::size_t>(BoneQuantity::angle);
constexpr auto x = static_cast<std::size_t>(BoneQuantity::x);
constexpr auto y = static_cast<std::size_t>(BoneQuantity::y);
constexpr auto length = static_cast<std::size_t>(BoneQuantity::length);

/// By their numbers; those of scene_with().
const std::array<LawPair, 5> law_pairs{LawPair{}, LawPair{VelocityLaw::accelerate, VelocityLaw::decelerate},
                                       LawPair{VelocityLaw::accelerate_decelerate, VelocityLaw::constant},
                                       LawPair{VelocityLaw::hold, VelocityLaw::accelerate},
                                       LawPair{VelocityLaw::decelerate, VelocityLaw::hold}};

/// Both swing beyond their ends.
constexpr int wild = 5;

RawScene scene_with(const std::vector<RawSkeleton>& skeletons)
{
    RawScene scene;
    scene.law_count = 5;
    scene.laws = bytes({0x21, 0x03, 0x14, 0x42,                               //
                        0x66, 0,    0,    0x00, 0xC0, 0,    0x20, 0x00, 0x60, // y from -2 to 3
                        0,    0,    0x00, 0xC0, 0,    0x20, 0x00, 0x60});
    for (const RawSkeleton& skeleton : skeletons)
        scene.bones = joined({scene.bones, skeleton_bytes(skeleton)});
    return scene;
}

/// All bones of a scene, set up.
class Puppet {
public:
    explicit Puppet(const std::vector<RawSkeleton>& skeletons)
        : file_{scene_with(skeletons).file()}, scene_{*SceneView::parse(file_)}, bones_(scene_.bone_count())
    {
        set_up_bones(scene_, bones_);
    }

    const std::vector<LiveBone>& at(Time time)
    {
        pose_bones(scene_, time, bones_);
        return bones_;
    }

private:
    Bytes file_;
    SceneView scene_;
    std::vector<LiveBone> bones_;
};

/// Of a row vector (x, y, 1).
using Matrix = std::array<std::array<double, 3>, 3>;

Matrix operator*(const Matrix& a, const Matrix& b)
{
    Matrix product{};
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            for (std::size_t i = 0; i < 3; ++i)
                product[row][column] += a[row][i] * b[i][column];
    return product;
}

Spot operator*(Spot p, const Matrix& m)
{
    return {p.x * m[0][0] + p.y * m[1][0] + m[2][0], p.x * m[0][1] + p.y * m[1][1] + m[2][1]};
}

Matrix moved(Spot by) { return {{{1, 0, 0}, {0, 1, 0}, {by.x, by.y, 1}}}; }

/// Clockwise on the screen.
Matrix turned(double radians)
{
    const double c = std::cos(radians);
    const double s = std::sin(radians);
    return {{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}};
}

Matrix stretched(double along) { return {{{along, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; }

double in_radians(double turns) { return turns / 65536 * 2 * std::numbers::pi; }

/// Where a bone lies on the canvas.
struct ExactFrame {
    Spot origin{0, 0};
    double angle = 0;
};

ExactFrame frame_in(const ExactFrame& parent, const std::array<double, 4>& values, double shift)
{
    const Spot origin{values[x] / 16 + shift, values[y] / 16};
    return {origin * turned(parent.angle) * moved(parent.origin), parent.angle + in_radians(values[angle])};
}

struct ExactBone {
    ExactFrame rest;
    ExactFrame posed;
    double rest_length = 0;
    double posed_length = 0;

    /// T(-O) R(-a) S(l' / l) R(a') T(O')
    Matrix map() const
    {
        return moved({-rest.origin.x, -rest.origin.y}) * turned(-rest.angle) *
               stretched(posed_length / rest_length) * turned(posed.angle) * moved(posed.origin);
    }
};

double value_between(double from, double to, Time begin, Time end, Time time, const VelocityLaw& law)
{
    const double passed = (time - begin).ticks;
    return from + (to - from) * exact_way(law, passed / (end - begin).ticks);
}

/// Before the first of the keys, between two of them, or behind the last one.
double exact_value(const std::vector<RawTrackKey>& keys, std::size_t quantity, bool shortest, Time time)
{
    if (time <= keys.front().time)
        return keys.front().value;
    for (std::size_t next = 1; next < keys.size(); ++next) {
        const RawTrackKey& from = keys[next - 1];
        const RawTrackKey& to = keys[next];
        if (time >= to.time)
            continue;
        const LawPair& laws = law_pairs.at(static_cast<std::size_t>(from.laws));
        double end = to.value;
        if (shortest && quantity == angle) {
            const int turn = ((to.value - from.value) % 65536 + 65536) % 65536; // 0 … 65535
            end = from.value + (turn < 32768 ? turn : turn - 65536);
        }
        return value_between(from.value, end, from.time, to.time, time, quantity == y ? laws.y : laws.x);
    }
    return keys.back().value;
}

std::array<double, 4> exact_values(const RawSkeleton& skeleton, const RawBone& bone, Time time)
{
    std::array<double, 4> values{};
    for (std::size_t quantity = 0; quantity < 4; ++quantity) {
        std::vector<RawTrackKey> keys = bone.keys[quantity].own;
        const auto& common = bone.keys[quantity].common;
        for (std::size_t i = 0; i < common.size(); ++i)
            keys.push_back({skeleton.common[i].time, skeleton.common[i].laws, common[i]});
        values[quantity] =
            keys.empty() ? bone.set_up[quantity] : exact_value(keys, quantity, !bone.turns_as_written, time);
    }
    return values;
}

std::vector<ExactBone> exact_bones(const RawSkeleton& skeleton, Time time)
{
    std::vector<ExactBone> exact;
    for (const RawBone& bone : skeleton.bones) {
        const ExactBone root{};
        const ExactBone& parent = bone.parent == 0 ? root : exact[static_cast<std::size_t>(bone.parent) - 1];
        std::array<double, 4> rest{};
        std::ranges::copy(bone.set_up, rest.begin());
        const std::array<double, 4> posed = exact_values(skeleton, bone, time);
        const double growth = bone.is_at_tip ? parent.posed_length - parent.rest_length : 0;
        exact.push_back({frame_in(parent.rest, rest, 0), frame_in(parent.posed, posed, growth),
                         rest[length] / 16, posed[length] / 16});
    }
    return exact;
}

int within(std::mt19937& random, int least, int most)
{
    return std::uniform_int_distribution<int>{least, most}(random);
}

std::int32_t random_value(std::mt19937& random, const RawBone& bone, std::size_t quantity)
{
    switch (static_cast<BoneQuantity>(quantity)) {
    case BoneQuantity::angle:
        return within(random, 0, 65535);
    case BoneQuantity::x:
    case BoneQuantity::y:
        return bone.set_up[quantity] + within(random, -16 * 20, 16 * 20);
    case BoneQuantity::length:
        return random() % 4 == 0 ? 0 : within(random, 0, 2 * bone.set_up[quantity]);
    }
    return 0;
}

std::vector<RawTrackKey> random_own_keys(std::mt19937& random, const RawBone& bone, std::size_t quantity)
{
    std::vector<RawTrackKey> keys(1 + random() % 3);
    Time time{within(random, 0, 2000)};
    for (RawTrackKey& key : keys) {
        key = {time, within(random, 0, 4), random_value(random, bone, quantity)};
        if (bone.turns_as_written && quantity == angle)
            key.value = within(random, -65536, 65536);
        time.ticks += within(random, 1, 5000);
    }
    return keys;
}

void add_random_keys(std::mt19937& random, std::size_t common_keys, RawBone& bone)
{
    for (std::size_t quantity = 0; quantity < 4; ++quantity) {
        if (random() % 2 == 0)
            continue;
        RawBoneKeys& keys = bone.keys[quantity];
        const bool must_be_own = common_keys == 0 || (bone.turns_as_written && quantity == angle);
        if (must_be_own || random() % 2 == 0)
            keys.own = random_own_keys(random, bone, quantity);
        else
            for (std::size_t i = 0; i < common_keys; ++i)
                keys.common.push_back(random_value(random, bone, quantity));
    }
}

/// Begins on the tip or along its parent; a root begins on the canvas, 512 px wide and high.
RawBone random_bone(std::mt19937& random, const std::vector<RawBone>& earlier, int parent)
{
    RawBone bone{.parent = parent};
    bone.set_up = {within(random, 0, 65535), within(random, 0, 512 * 16), within(random, 0, 512 * 16),
                   within(random, 4 * 16, 60 * 16)};
    if (parent == 0)
        return bone;
    bone.is_at_tip = random() % 2 == 0;
    const std::int32_t parent_length = earlier[static_cast<std::size_t>(parent) - 1].set_up[length];
    bone.set_up[x] = bone.is_at_tip ? parent_length : within(random, 0, parent_length);
    bone.set_up[y] = random() % 2 == 0 ? 0 : within(random, -160, 160);
    return bone;
}

enum class Turns { shortest, as_written };

/// One root or several, with bones up to eight levels deep.
RawSkeleton random_skeleton(std::mt19937& random, Turns turns = Turns::shortest)
{
    RawSkeleton skeleton;
    Time time{within(random, 0, 2000)};
    for (auto count = random() % 4; count > 0; --count) {
        skeleton.common.push_back({time, within(random, 0, 4)});
        time.ticks += within(random, 1, 5000);
    }
    std::vector<int> levels{0};
    for (auto count = 1 + random() % 12; count > 0; --count) {
        int parent = static_cast<int>(skeleton.bones.size()); // mostly in a chain
        if (random() % 3 == 0 || levels.back() == 8)
            parent = within(random, 0, parent);
        const int level = levels[static_cast<std::size_t>(parent)] + 1;
        if (level > 8)
            continue;
        levels.push_back(level);
        skeleton.bones.push_back(random_bone(random, skeleton.bones, parent));
        RawBone& bone = skeleton.bones.back();
        bone.turns_as_written = turns == Turns::as_written && random() % 2 == 0;
        add_random_keys(random, skeleton.common.size(), bone);
    }
    return skeleton;
}

Point random_point_around(std::mt19937& random, const ExactBone& bone)
{
    const auto near = [&random](double middle) { return std::floor(middle) + within(random, -100, 100); };
    return pixels(near(bone.rest.origin.x), near(bone.rest.origin.y));
}

/// Of the points that the bones carry, and of their origins.
double worst_error(const RawSkeleton& skeleton, const std::vector<LiveBone>& live, Time time,
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
    for (int round = 0; round < 3000; ++round) {
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
Point carried(std::int32_t from, std::int32_t to, bool as_written, Time time, Point at)
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
    for (int round = 0; round < 500; ++round) {
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
        for (const LiveBone& bone : puppet.at({within(random, 0, 10 * 1024)}))
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
    for (int round = 0; round < 100; ++round) {
        const std::vector<RawSkeleton> skeletons{random_skeleton(random), random_skeleton(random),
                                                 random_skeleton(random)};
        Puppet together{skeletons};
        const Time time{within(random, 0, 10 * 1024)};
        together.at({within(random, 0, 10 * 1024)});
        std::size_t number = 0;
        for (const RawSkeleton& skeleton : skeletons) {
            Puppet alone{{skeleton}};
            for (const LiveBone& bone : alone.at(time)) {
                const Point point = pixels(within(random, 0, 512), within(random, 0, 512));
                REQUIRE(together.at(time)[number++](point) == bone(point));
            }
        }
    }
}

TEST_CASE("angles take the shortest way, just half a turn against the clock")
{
    const auto half_way = [](std::int32_t from, std::int32_t to) {
        return carried(from, to, false, Time::frame(1), pixels(100, 0));
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
    CHECK(carried(5 * 65536, -3 * 65536 + 16384, false, Time::frame(1), pixels(64, 0)) ==
          carried(0, 16384, false, Time::frame(1), pixels(64, 0)));
}

TEST_CASE("angles as written make all of their turns")
{
    const auto at = [](int ticks) { return carried(0, -16 * 65536, true, {ticks}, pixels(100, 0)); };
    CHECK(at(1024) == pixels(100, 0)); // 8 turns
    CHECK(at(32) == pixels(0, -100));  // a quarter of one
    CHECK(at(64) == pixels(-100, 0));
    CHECK(carried(0, 32768, true, Time::frame(1), pixels(100, 0)) == pixels(0, 100));
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
    swinging.keys[length].own = {{{}, wild, 160}, {Time::frame(10), 0, 0}};
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
        bone.keys[angle].own = {{{}, wild, 1}, {Time::frame(10), 0, 65535}};
        bone.keys[x].own = {{{}, wild, 32767}, {Time::frame(10), 0, -32768}};
        bone.keys[y].own = {{{}, wild, -32768}, {Time::frame(10), 0, 32767}};
        bone.keys[length].own = {{{}, wild, 0}, {Time::frame(10), 0, 65535}};
        bone.is_at_tip = parent > 15;
        skeleton.bones.push_back(bone);
    }
    Puppet puppet{{skeleton}};
    for (int frame = 0; frame <= 10; ++frame)
        for (const LiveBone& bone : puppet.at(Time::frame(frame)))
            for (const Point point : {pixels(-2048, 2047), pixels(2047, -2048)}) {
                const Point to = bone(point);
                for (const Fixed side : {to.x, to.y, bone.frame().origin.x, bone.frame().origin.y})
                    CHECK(std::abs(side.raw()) <= Fixed::pixels(16383).raw());
            }
}

}
