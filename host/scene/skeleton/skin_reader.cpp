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
#include <numeric>
#include <sstream>
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
    for (const kdl::Value* bone : {written.bone, written.bones})
        if (bone != nullptr)
            context.report.error(bone->place, "a bone carries only an object that has a skin", hint);
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
        if (key.match != Match::count)
            good = context.report.error(key.place,
                                        std::string{"match="} + std::string{match_name(key.match)} +
                                            " does not work with a skin",
                                        "use match=count");
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

std::optional<std::size_t> read_bone(const kdl::Value& value, const Skeleton& skeleton, SceneContext& context)
{
    const auto name = read_name(value, context.report);
    return name ? read_bone_name(*name, value.place, skeleton.bones.bones, context) : std::nullopt;
}

/// Each of them once; names with blanks between them.
std::optional<std::vector<std::size_t>> read_bones(const kdl::Value& value, const Skeleton& skeleton,
                                                   SceneContext& context)
{
    const auto names = read_text(value, context.report);
    if (!names)
        return std::nullopt;
    bool good = true;
    std::vector<std::size_t> bones;
    std::istringstream words{std::string{*names}};
    for (std::string name; words >> name && !context.report.full();) {
        const auto bone = read_bone_name(name, value.place, skeleton.bones.bones, context);
        if (bone && std::ranges::find(bones, *bone) != bones.end())
            good = context.report.error(value.place, in_quotes(name) + " stands here twice",
                                        "remove one of them");
        good = good && bone;
        bones.push_back(bone.value_or(0));
    }
    if (bones.empty())
        good = context.report.error(value.place, "no bone is named here", "write bones=\"NAME NAME\"");
    return good ? std::optional{bones} : std::nullopt;
}

std::vector<std::size_t> all_bones(const Skeleton& skeleton)
{
    std::vector<std::size_t> bones(skeleton.bones.bones.size());
    std::iota(bones.begin(), bones.end(), std::size_t{0});
    return bones;
}

bool refuse_both(SourceSpan place, std::string_view one, std::string_view other, SceneContext& context)
{
    return context.report.error(
        place, "both " + std::string{one} + " and " + std::string{other} + " say what carries the object",
        "leave it to one of them");
}

std::optional<std::vector<Binding>> bound_to_one(const WrittenSkin& written, const Skeleton& skeleton,
                                                 std::size_t points, SceneContext& context)
{
    if (written.bones != nullptr)
        refuse_both(written.bones->place, "bone=", "bones=", context);
    if (written.weights != nullptr)
        refuse_both(written.weights->name_span, "bone=", "weights", context);
    const auto bone = read_bone(*written.bone, skeleton, context);
    return bone ? std::optional{std::vector<Binding>(points, bound({{*bone, 1}}))} : std::nullopt;
}

std::optional<std::vector<Binding>> read_bindings(const WrittenSkin& written, const Skeleton& skeleton,
                                                  const std::vector<Vec2>& spots, SceneContext& context)
{
    if (written.bone != nullptr)
        return bound_to_one(written, skeleton, spots.size(), context);
    if (written.bones != nullptr && written.weights != nullptr && !written.weights->children.empty())
        refuse_both(written.weights->name_span, "bones=", "weights", context);
    const auto bones =
        written.bones == nullptr ? all_bones(skeleton) : read_bones(*written.bones, skeleton, context);
    if (!bones)
        return std::nullopt;
    return read_weights(written.weights, skeleton, *bones, spots, written.place, context);
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
