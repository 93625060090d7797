#include "host/scene/skeleton/skin_reader.hpp"

#include "host/geometry/outline.hpp"
#include "host/scene/model.hpp"
#include "host/scene/skeleton/binding.hpp"
#include "host/scene/skeleton/bone_reader.hpp"
#include "host/scene/skeleton/weights_reader.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/text/characters.hpp"
#include "host/text/suggestion.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace kfast::scene {

namespace {

/// The points of a drawing that have bindings of their own. The closing point of a closed stroke follows its
/// first and does not count.
class SkinPoints {
public:
    explicit SkinPoints(const Drawing& drawing);

    const std::vector<Vec2>& spots() const { return spots_; }
    /// The bindings of each point as the format counts them; `bindings` are those of spots().
    std::vector<Binding> bindings_of_all(const std::vector<Binding>& bindings) const;

private:
    void add(const Stroke& stroke);
    void add(Point point);

    std::vector<Vec2> spots_;
    std::vector<std::size_t> all_; ///< indices into spots_
};

SkinPoints::SkinPoints(const Drawing& drawing)
{
    for (const Stroke& stroke : drawing.strokes)
        add(stroke);
}

std::vector<Binding> SkinPoints::bindings_of_all(const std::vector<Binding>& bindings) const
{
    std::vector<Binding> all;
    all.reserve(all_.size());
    for (const std::size_t index : all_)
        all.push_back(bindings[index]);
    return all;
}

void SkinPoints::add(const Stroke& stroke)
{
    const std::size_t first = spots_.size();
    add(stroke.from);
    for (const Segment& segment : stroke.segments)
        if (&segment == &stroke.segments.back() && segment.to == stroke.from)
            all_.push_back(first);
        else
            add(segment.to);
}

void SkinPoints::add(Point point)
{
    all_.push_back(spots_.size());
    spots_.push_back({point.x / 16.0, point.y / 16.0});
}

void refuse_without_skin(const WrittenSkin& written, SceneContext& context)
{
    constexpr auto hint = "add skin=NAME to the object, with the name of a skeleton";
    if (written.bone != nullptr)
        context.report.error(written.bone->place, "a bone carries only an object that has a skin", hint);
    if (written.weights != nullptr)
        context.report.error(written.weights->name_span, "weights need a skin", hint);
}

std::optional<std::size_t> find_skeleton(const kdl::Value& value, SceneContext& context)
{
    const auto name = read_name(value, context.report);
    if (!name)
        return std::nullopt;
    const auto skeleton = context.skeletons.find(*name);
    const auto known = context.skeletons.names();
    if (!skeleton)
        context.report.error(value.place, "unknown skeleton " + in_quotes(*name),
                             known.empty() ? "write it on the outermost level: bones NAME { … }"
                                           : suggestion(*name, known));
    else
        context.skeletons.entries[*skeleton].is_used = true;
    return skeleton;
}

/// Only whole strokes have points at rest on the first drawing.
bool check_keys(const std::vector<Key>& keys, const Drawing& first, SceneContext& context)
{
    bool good = true;
    for (const Key& key : keys) {
        const std::size_t strokes = key.drawing.strokes.size();
        if (key.match == Match::length)
            good =
                context.report.error(key.place, "match=length does not work with a skin", "use match=count");
        if (strokes != 0 && strokes != first.strokes.size())
            good = context.report.error(key.place,
                                        "with a skin, all drawings have as many strokes as the first: " +
                                            std::to_string(first.strokes.size()) + ", not " +
                                            std::to_string(strokes),
                                        "draw it with as many, or put some strokes into another object");
    }
    return good;
}

const Drawing& first_seen(const std::vector<Key>& keys)
{
    const auto is_seen = [](const Key& key) { return !key.drawing.strokes.empty(); };
    const auto first = std::ranges::find_if(keys, is_seen);
    return first == keys.end() ? keys.front().drawing : first->drawing;
}

std::optional<std::vector<Binding>> read_bindings(const WrittenSkin& written, const Skeleton& skeleton,
                                                  const std::vector<Vec2>& spots, SceneContext& context)
{
    if (written.bone == nullptr)
        return read_weights(written.weights, skeleton, spots, written.place, context);
    if (written.weights != nullptr)
        context.report.error(written.weights->name_span, "both bone= and weights say what carries the object",
                             "leave it to one of them");
    const auto name = read_name(*written.bone, context.report);
    const auto bone =
        name ? read_bone_name(*name, written.bone->place, skeleton.bones.bones, context) : std::nullopt;
    if (!bone)
        return std::nullopt;
    return std::vector<Binding>(spots.size(), bound({{*bone, 1}}));
}

}

std::optional<Skin> read_skin(const WrittenSkin& written, const std::vector<Key>& keys, SceneContext& context)
{
    if (written.skeleton == nullptr) {
        refuse_without_skin(written, context);
        return std::nullopt;
    }
    const auto index = find_skeleton(*written.skeleton, context);
    if (!index || !context.skeletons.entries[*index].is_valid || keys.empty())
        return std::nullopt;
    const Drawing& first = first_seen(keys);
    const SkinPoints points{first};
    const bool good = check_keys(keys, first, context);
    const auto bindings = read_bindings(written, context.skeletons.entries[*index], points.spots(), context);
    if (!good || !bindings)
        return std::nullopt;
    return Skin{*index, points.bindings_of_all(*bindings), written.place, written.turns_changes};
}

}
