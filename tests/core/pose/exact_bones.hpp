#pragma once

#include "tests/core/math/exact_matrix.hpp"
#include "tests/core/puppet.hpp"
#include "tests/core/raw_bones.hpp"
#include "tests/core/time/exact_law.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

/// Bones in motion, by the words of docs/format.md.
namespace kfast::test {

inline double in_radians(double turns) { return turns / 65536 * 2 * std::numbers::pi; }

/// Where a bone lies on the canvas.
struct ExactFrame {
    Spot origin{0, 0};
    double angle = 0;
};

inline ExactFrame frame_in(const ExactFrame& parent, const std::array<double, 4>& values, double shift)
{
    const Spot origin{values[of_bone::x] / 16 + shift, values[of_bone::y] / 16};
    return {origin * turned(parent.angle) * moved(parent.origin),
            parent.angle + in_radians(values[of_bone::angle])};
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

inline double value_between(double from, double to, Time begin, Time end, Time time, const VelocityLaw& law)
{
    const double passed = (time - begin).ticks;
    return from + (to - from) * exact_progress(law, passed / (end - begin).ticks);
}

/// Before the first of the keys, between two of them, or behind the last one.
inline double exact_value(const std::vector<RawTrackKey>& keys, std::size_t quantity, bool shortest,
                          Time time)
{
    if (time <= keys.front().time)
        return keys.front().value;
    for (std::size_t next = 1; next < keys.size(); ++next) {
        const RawTrackKey& from = keys[next - 1];
        const RawTrackKey& to = keys[next];
        if (time >= to.time)
            continue;
        const LawPair& laws = Puppet::laws.at(static_cast<std::size_t>(from.laws));
        double end = to.value;
        if (shortest && quantity == of_bone::angle) {
            const int turn = ((to.value - from.value) % 65536 + 65536) % 65536; // 0 … 65535
            end = from.value + (turn < 32768 ? turn : turn - 65536);
        }
        return value_between(from.value, end, from.time, to.time, time,
                             quantity == of_bone::y ? laws.y : laws.x);
    }
    return keys.back().value;
}

inline std::array<double, 4> exact_values(const RawSkeleton& skeleton, const RawBone& bone, Time time)
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

inline std::vector<ExactBone> exact_bones(const RawSkeleton& skeleton, Time time)
{
    std::vector<ExactBone> exact;
    for (const RawBone& bone : skeleton.bones) {
        const ExactBone root{};
        const ExactBone& parent = bone.parent == 0 ? root : exact[static_cast<std::size_t>(bone.parent) - 1];
        std::array<double, 4> rest{};
        std::ranges::copy(bone.set_up, rest.begin());
        const std::array<double, 4> posed = exact_values(skeleton, bone, time);
        const double extension = bone.is_at_tip ? parent.posed_length - parent.rest_length : 0;
        exact.push_back({frame_in(parent.rest, rest, 0), frame_in(parent.posed, posed, extension),
                         rest[of_bone::length] / 16, posed[of_bone::length] / 16});
    }
    return exact;
}

}
