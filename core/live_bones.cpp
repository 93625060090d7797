#include "core/live_bones.hpp"

#include "core/held_point.hpp"
#include "core/passage.hpp"
#include "core/sum_of_products.hpp"
#include "core/work.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace kfast {
namespace {

using FineValues = std::array<std::int32_t, bone_quantity_count>;

constexpr std::int64_t most_stretch = 64 * std::int64_t{Fixed::one};

std::int32_t of(std::span<const std::int32_t, bone_quantity_count> values, BoneQuantity quantity)
{
    return values[static_cast<std::size_t>(quantity)];
}

/// Of a quantity in 1/16 px, in 1/256 of it.
Fixed pixels(std::int32_t fine) { return Fixed::from_raw(fine * (Fixed::one >> (4 + fine_bits))); }

/// What is at (x, y) in the frame of `parent`.
Point on_canvas(const BoneFrame& parent, Fixed x, Fixed y)
{
    constexpr std::int64_t half = 1 << 29;
    const std::int64_t across = std::int64_t{parent.cosine} * x.raw() - std::int64_t{parent.sine} * y.raw();
    const std::int64_t down = std::int64_t{parent.sine} * x.raw() + std::int64_t{parent.cosine} * y.raw();
    return held_point(parent.origin.x.raw() + ((across + half) >> 30),
                      parent.origin.y.raw() + ((down + half) >> 30));
}

BoneFrame frame_in(const BoneFrame& parent, std::span<const std::int32_t, bone_quantity_count> fine,
                   Fixed shift)
{
    const FineAngle angle = parent.angle + FineAngle::of_fine(of(fine, BoneQuantity::angle));
    return {.origin = on_canvas(parent, pixels(of(fine, BoneQuantity::x)) + shift,
                                pixels(of(fine, BoneQuantity::y))),
            .angle = angle,
            .cosine = cosine(angle),
            .sine = sine(angle)};
}

FineValues values_at_rest(const BoneView& bone)
{
    FineValues fine;
    std::ranges::transform(bone.set_up, fine.begin(),
                           [](std::int32_t value) { return value * (1 << fine_bits); });
    return fine;
}

/// Two unit components in Q30, multiplied.
std::int64_t q30_product(std::int32_t a, std::int32_t b) { return (std::int64_t{a} * b) >> 30; }

/// stretch * a + b of Q30 numbers, as a Q16 factor.
std::int32_t factor(std::int64_t stretch, std::int64_t a, std::int64_t b)
{
    return static_cast<std::int32_t>((((stretch * a) >> 16) + b + (1 << 13)) >> 14);
}

/// The common beats of a skeleton at one moment.
class CommonMoment {
public:
    CommonMoment(const SceneView& scene, const BonesView& bones, const Moment& moment)
    {
        if (bones.common_beats().at_end())
            return;
        const Time time = moment.at(bones.common_beats().clock());
        const auto [from, to] = interval_at(bones.common_beats(), time);
        from_ = from.index;
        to_ = to.index;
        progress_ = progress_between(from.time, to.time, time, scene.laws(from.laws));
    }

    Passage passage(const BoneKeys& keys, LawAxis axis) const
    {
        return {keys.value(from_), keys.value(to_), axis == LawAxis::y ? progress_.y : progress_.x};
    }

private:
    std::uint32_t from_ = 0;
    std::uint32_t to_ = 0;
    Progress progress_;
};

/// Reads what the quantities of bones come to at one moment.
class PoseReader {
public:
    PoseReader(const SceneView& scene, const BonesView& bones, const Moment& moment)
        : scene_{scene}, moment_{moment}, common_{scene, bones, moment}
    {
    }

    FineValues values(const BoneView& bone) const
    {
        FineValues fine = values_at_rest(bone);
        for (std::size_t i = 0; i < bone_quantity_count; ++i)
            if (bone.keys[i].kind() != BoneKeys::Kind::none)
                fine[i] = value(bone, static_cast<BoneQuantity>(i));
        return fine;
    }

private:
    std::int32_t value(const BoneView& bone, BoneQuantity quantity) const
    {
        const BoneKeys& keys = bone.keys_of(quantity);
        const LawAxis axis = quantity == BoneQuantity::y ? LawAxis::y : LawAxis::x;
        Passage passage =
            keys.kind() == BoneKeys::Kind::common
                ? common_.passage(keys, axis)
                : passage_at(scene_, keys.keys(), axis, moment_.at(keys.keys().beats().clock()));
        if (quantity == BoneQuantity::angle && !bone.turns_as_written)
            passage.to = passage.from + shortest_turn(BinaryAngle::from_raw(passage.from),
                                                      BinaryAngle::from_raw(passage.to));
        return fine_value(passage);
    }

    const SceneView& scene_;
    Moment moment_;
    CommonMoment common_;
};

}

void LiveBone::set_up(const BoneView& bone, const LiveBone* parent)
{
    rest_ = frame_in(parent == nullptr ? BoneFrame{} : parent->rest_, values_at_rest(bone), {});
}

void LiveBone::pose(const BoneView& bone, const LiveBone* parent,
                    std::span<const std::int32_t, bone_quantity_count> fine)
{
    did(Work::bone);
    const Fixed shift = parent != nullptr && bone.is_at_tip ? parent->growth_ : Fixed{};
    posed_ = frame_in(parent == nullptr ? BoneFrame{} : parent->posed_, fine, shift);
    const std::int64_t set_up_length = std::int64_t{bone.at_rest(BoneQuantity::length)} << fine_bits;
    const std::int64_t length = std::max<std::int32_t>(of(fine, BoneQuantity::length), 0);
    growth_ = pixels(static_cast<std::int32_t>(length - set_up_length));
    const std::int64_t stretch = std::min(((length << 16) + set_up_length / 2) / set_up_length, most_stretch);
    const auto& [c, s] = std::pair{rest_.cosine, rest_.sine};
    const auto& [posed_c, posed_s] = std::pair{posed_.cosine, posed_.sine};
    xx_ = factor(stretch, q30_product(posed_c, c), q30_product(posed_s, s));
    xy_ = factor(stretch, q30_product(posed_c, s), -q30_product(posed_s, c));
    yx_ = factor(stretch, q30_product(posed_s, c), -q30_product(posed_c, s));
    yy_ = factor(stretch, q30_product(posed_s, s), q30_product(posed_c, c));
}

Point LiveBone::operator()(Point point) const
{
    did(Work::carried_point);
    const Point from = point - rest_.origin;
    const std::int32_t x = from.x.raw();
    const std::int32_t y = from.y.raw();
    if (is_modest_way(x) && is_modest_way(y) && is_modest_factor(xx_) && is_modest_factor(xy_) &&
        is_modest_factor(yx_) && is_modest_factor(yy_)) // mostly
        return {held(posed_.origin.x.raw() + short_sum_of_products(xx_, x, xy_, y)),
                held(posed_.origin.y.raw() + short_sum_of_products(yx_, x, yy_, y))};
    return held_point(posed_.origin.x.raw() + sum_of_products(xx_, x, xy_, y),
                      posed_.origin.y.raw() + sum_of_products(yx_, x, yy_, y));
}

Affine LiveBone::map() const
{
    const std::int32_t x = rest_.origin.x.raw();
    const std::int32_t y = rest_.origin.y.raw();
    return {.xx = xx_,
            .xy = xy_,
            .yx = yx_,
            .yy = yy_,
            .x0 = posed_.origin.x.raw() - sum_of_products(xx_, x, xy_, y),
            .y0 = posed_.origin.y.raw() - sum_of_products(yx_, x, yy_, y)};
}

void set_up_bones(const SceneView& scene, std::span<LiveBone> live)
{
    for (BonesCursor skeletons = scene.skeletons(); !skeletons.at_end();) {
        std::size_t number = 0;
        for (BoneCursor bones = skeletons.next().bones(); !bones.at_end(); ++number) {
            const BoneView bone = bones.next();
            live[number] = {};
            live[number].set_up(bone, bone.parent == 0 ? nullptr : &live[bone.parent - 1]);
        }
        live = live.subspan(number);
    }
}

void pose_bones(const SceneView& scene, const Moment& moment, std::span<LiveBone> live)
{
    for (BonesCursor skeletons = scene.skeletons(); !skeletons.at_end();) {
        const BonesView view = skeletons.next();
        const PoseReader pose{scene, view, moment};
        std::size_t number = 0;
        for (BoneCursor bones = view.bones(); !bones.at_end(); ++number) {
            const BoneView bone = bones.next();
            live[number].pose(bone, bone.parent == 0 ? nullptr : &live[bone.parent - 1], pose.values(bone));
        }
        live = live.subspan(number);
    }
}

}
