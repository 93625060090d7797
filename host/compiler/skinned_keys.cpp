#include "host/compiler/skinned_keys.hpp"

#include "core/equalize.hpp"
#include "core/key_interval.hpp"
#include "core/kfb_limits.hpp"
#include "host/compiler/curve_pieces.hpp"
#include "host/compiler/moments.hpp"
#include "host/compiler/posed_drawing.hpp"
#include "host/compiler/skinned_drawing.hpp"
#include "host/compiler/time_code.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace kfast {
namespace {

const scene::Drawing& first_seen(const std::vector<scene::Key>& keys)
{
    const auto is_seen = [](const scene::Key& key) { return !key.drawing.strokes.empty(); };
    const auto first = std::ranges::find_if(keys, is_seen);
    return first == keys.end() ? keys.front().drawing : first->drawing;
}

std::vector<SkinnedDrawing> skinned_drawings(const scene::Object& object, Diagnostics& diagnostics)
{
    const scene::Drawing& first = first_seen(object.keys);
    std::vector<SkinnedDrawing> drawings;
    for (const scene::Key& key : object.keys) {
        auto skinned = skinned_drawing(first, object.skin->bindings, key.drawing);
        if (!skinned)
            diagnostics.error(key.place,
                              "to follow bones as the first drawing does, this one takes more than " +
                                  std::to_string(kfb::max_drawing_points) +
                                  " points, as many as a drawing holds",
                              "draw both with fewer points");
        else if (object.skin->turns_changes)
            skinned->at_rest.reset();
        drawings.push_back(std::move(skinned).value_or(SkinnedDrawing{}));
    }
    return drawings;
}

bool has_curve(const scene::Drawing& drawing)
{
    return std::ranges::any_of(drawing.strokes, [](const scene::Stroke& stroke) {
        return std::ranges::any_of(stroke.segments, &scene::Segment::cubic);
    });
}

double most_bend(const PosedDrawing& from, const PosedDrawing& to, Progress way)
{
    double most = 0;
    EqualizedPair pair{PosedReader{from}, PosedReader{to}};
    while (const std::uint32_t segments = pair.next_stroke())
        for (std::uint32_t i = 0; i < segments; ++i) {
            const Pair<Segment> both = pair.next_segment();
            most = std::max(most, bend_of(tween(both.a, both.b, way.x, way.y)));
        }
    return most;
}

/// A key, the way from it to the next, and when they are shown. The last leads to itself.
struct SkinnedWay {
    const SkinnedDrawing& from;
    const SkinnedDrawing& to;
    Time key;
    Time next;
    LawPair laws;
    Time since; ///< the first key is shown before its time
    Time until; ///< the last one is shown to the end of the scene
};

/// A skeleton in motion, for what has to be known of it beforehand.
class Posing {
public:
    explicit Posing(const scene::Bones& skeleton)
        : bones_{skeleton.bones}, set_up_{scene::frames_as_set_up(skeleton.bones)}
    {
        for (const scene::Bone& bone : bones_)
            for (const auto& keys : bone.keys)
                for (const scene::TrackKey& key : keys)
                    key_times_.push_back(key.time);
        std::ranges::sort(key_times_);
        key_times_.erase(std::unique(key_times_.begin(), key_times_.end()), key_times_.end());
    }

    /// When any bone has a key: each time once, in order.
    const std::vector<Time>& key_times() const { return key_times_; }

    /// How much the curves of `way` bend at most at one moment. Before its way begins, a key is shown
    /// undivided, with longer curves.
    double bend_at(const SkinnedWay& way, Time moment) const
    {
        const std::vector<scene::BoneMotion> motions = motions_at(moment);
        const PosedDrawing from{way.from, motions};
        if (moment <= way.key || way.key == way.next)
            return most_bend(from, from, {});
        const Progress progress = progress_between(way.key, way.next, moment, way.laws);
        return most_bend(from, PosedDrawing{way.to, motions}, progress);
    }

private:
    std::vector<scene::BoneMotion> motions_at(Time time) const
    {
        const std::vector<scene::BoneFrame> frames = scene::frames_at(bones_, time);
        std::vector<scene::BoneMotion> motions;
        for (std::size_t i = 0; i < frames.size(); ++i)
            motions.emplace_back(set_up_[i], frames[i]);
        return motions;
    }

    const std::vector<scene::Bone>& bones_;
    std::vector<scene::BoneFrame> set_up_;
    std::vector<Time> key_times_;
};

/// How much the curves of a way bend at most at any moment. Bones bend and stretch curves in ways that no
/// formula bounds closely. So it is looked at how they do at many moments, and at more of them where bends
/// that may be the largest change between neighbours by more than the margin, which is for what lies between.
class BendSearch {
public:
    BendSearch(const Posing& posing, const SkinnedWay& way) : posing_{posing}, way_{way} {}

    double most()
    {
        if (!has_curve(way_.from.drawing) && !has_curve(way_.to.drawing))
            return 0;
        look_along(way_.since, way_.key);
        look_along(way_.key, way_.until);
        return margin * most_;
    }

private:
    static constexpr double margin = 1.1;
    static constexpr int deepest = 6;

    struct Sample {
        Time time;
        double bend;
    };

    void look_along(Time since, Time until)
    {
        std::vector<Sample> samples;
        for (const Time moment : moments_between(since, until, posing_.key_times()))
            samples.push_back(look(moment));
        for (std::size_t i = 0; i + 1 < samples.size(); ++i)
            look_between(samples[i], samples[i + 1], deepest);
    }

    Sample look(Time time)
    {
        const Sample sample{time, posing_.bend_at(way_, time)};
        most_ = std::max(most_, sample.bend);
        return sample;
    }

    void look_between(const Sample& a, const Sample& b, int depth)
    {
        if (b.time.ticks - a.time.ticks < 2 || depth == 0)
            return;
        const Sample middle = look({a.time.ticks + (b.time.ticks - a.time.ticks) / 2});
        const auto [low, high] = std::minmax({a.bend, middle.bend, b.bend});
        if (high + (high - low) <= margin * most_)
            return;
        look_between(a, middle, depth - 1);
        look_between(middle, b, depth - 1);
    }

    const Posing& posing_;
    const SkinnedWay& way_;
    double most_ = 0;
};

/// Points in a row that follow the same bones are stored as one run.
void write_runs(const std::vector<scene::Binding>& bindings, ByteWriter& bytes)
{
    for (auto run = bindings.begin(); run != bindings.end();) {
        const auto end = std::find_if(run, bindings.end(),
                                      [run](const scene::Binding& binding) { return binding != *run; });
        const auto points = static_cast<std::uint32_t>(end - run);
        bytes.varint(4 * (points - 1) + static_cast<std::uint32_t>(run->size()) - 1);
        for (const scene::BoneWeight& share : *run) {
            bytes.u8(static_cast<std::uint32_t>(share.bone));
            if (&share != &run->back())
                bytes.u8(static_cast<std::uint32_t>(share.weight));
        }
        run = end;
    }
}

std::uint32_t offset_of_skin(const SkinnedDrawing& skinned, DrawingPool& drawings)
{
    ByteWriter skin;
    skin.varint(skinned.at_rest ? 1 + drawings.offset_of(*skinned.at_rest) : 0);
    write_runs(skinned.bindings, skin);
    return drawings.offset_of(skin.bytes());
}

std::uint64_t points_of(const SkinnedDrawing& skinned)
{
    const std::uint64_t own = point_count(skinned.drawing) + 1;
    return skinned.at_rest ? 2 * own : own;
}

/// From key `i` of `object`, whose drawings are `skinned`.
SkinnedWay way_from(std::size_t i, const scene::Object& object, const std::vector<SkinnedDrawing>& skinned,
                    Time end_of_scene)
{
    const scene::Key& key = object.keys[i];
    const std::size_t to = std::min(i + 1, skinned.size() - 1);
    const Time next = object.keys[to].time;
    return {.from = skinned[i],
            .to = skinned[to],
            .key = key.time,
            .next = next,
            .laws = to == i ? LawPair{} : key.laws,
            .since = i == 0 ? Time{} : key.time,
            .until = to == i ? std::max(end_of_scene, key.time) : next};
}

}

PackedKeys packed_skinned_keys(const scene::Object& object, const scene::Scene& scene, double scale,
                               LawTable& laws, DrawingPool& drawings, Diagnostics& diagnostics)
{
    const std::vector<SkinnedDrawing> skinned = skinned_drawings(object, diagnostics);
    const Posing posing{scene.bones[object.skin->bones]};
    PackedKeys packed;
    ByteWriter bytes;
    Time before;
    for (std::size_t i = 0; i < skinned.size(); ++i) {
        const SkinnedWay way = way_from(i, object, skinned, scene.length);
        bytes.varint(time_code(way.key - before));
        bytes.u8(laws.number_of(way.laws, object.keys[i].place));
        bytes.varint(pieces_for_bend(BendSearch{posing, way}.most(), scale));
        bytes.varint(drawings.offset_of(skinned[i].drawing));
        bytes.varint(offset_of_skin(skinned[i], drawings));
        packed.points += points_of(skinned[i]);
        before = way.key;
    }
    packed.bytes = bytes.bytes();
    return packed;
}

}
