#include "host/scene/skeleton/weights_reader.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/skeleton/bone_reader.hpp"
#include "host/scene/skeleton/bone_regions.hpp"
#include "host/scene/values/value_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/characters.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <utility>

namespace kfast::scene {
namespace {

constexpr NodeForm weights_form{weights_name, "weights auto, or weights { BONE WEIGHT }", 0, 1, true};
constexpr NodeForm points_form{points_name, "points FIRST LAST { BONE WEIGHT }", 1, 2, true};

/// `name` is that of a bone.
NodeForm weight_form(std::string_view name) { return {name, "BONE WEIGHT", 1, 1}; }

constexpr Range weights_range{0, 1000};

constexpr Range point_numbers{1, double{max_points}};

enum class Spread : std::uint8_t {
    by_distance, ///< the nearer a bone, the more
    evenly,
};

constexpr std::array spreads{Word<Spread>{"auto", Spread::by_distance}, Word<Spread>{"mean", Spread::evenly}};

std::string place_text(Vec2 spot) { return text_of(spot.x) + ", " + text_of(spot.y); }

/// "3 points" or "1 point"
std::string points_text(std::size_t count)
{
    return std::to_string(count) + (count == 1 ? " point" : " points");
}

Binding spread_out(std::vector<WeightedBone> bones, Spread spread)
{
    if (spread == Spread::by_distance)
        return coarsely_bound(std::move(bones));
    std::ranges::stable_sort(bones, std::ranges::greater{}, &WeightedBone::weight);
    bones.resize(std::min(bones.size(), max_bones_at_point));
    for (WeightedBone& bone : bones)
        bone.weight = 1;
    return bound(std::move(bones));
}

void warn_of_points_outside(std::size_t count, Vec2 first, SourceSpan place, SceneContext& context)
{
    const std::string where = " in no region of a bone, " + std::string{count == 1 ? "" : "the first "};
    context.report.warning(place,
                           points_text(count) + " of this object " + (count == 1 ? "lies" : "lie") + where +
                               "at " + place_text(first) + "; the nearest bone takes " +
                               (count == 1 ? "it" : "them"),
                           "let a bone have a larger region=…, or give weights");
}

std::vector<Binding> weights_of_regions(const BoneRegions& regions, const std::vector<Vec2>& spots,
                                        Spread spread, SourceSpan place, SceneContext& context)
{
    std::vector<Binding> bindings;
    std::vector<Vec2> outside;
    for (const Vec2 spot : spots) {
        std::vector<WeightedBone> bones = regions.around(spot);
        if (bones.empty()) {
            outside.push_back(spot);
            bones = {{regions.nearest(spot), 1}};
        }
        bindings.push_back(spread_out(std::move(bones), spread));
    }
    if (!outside.empty())
        warn_of_points_outside(outside.size(), outside.front(), place, context);
    return bindings;
}

/// Weights that are given explicitly.
class GivenWeights {
public:
    GivenWeights(const kdl::Node& node, const std::vector<Bone>& bones, const std::vector<Vec2>& spots,
                 SceneContext& context)
        : node_{node},
          bones_{bones},
          spots_{spots},
          context_{context},
          bindings_(spots.size()),
          places_(spots.size())
    {
    }

    std::optional<std::vector<Binding>> read()
    {
        const auto is_points = [](const kdl::Node& node) { return node.name == points_form.name; };
        const auto first = std::ranges::find_if(node_.children, is_points);
        if (first == node_.children.end())
            return read_one();
        const auto other = std::ranges::find_if_not(node_.children, is_points);
        if (other != node_.children.end())
            is_good_ = context_.report.error(other->name_span,
                                             "weights are either those of all points, or of some points each",
                                             "put it into braces: points FIRST LAST { BONE WEIGHT }");
        for (const kdl::Node& child : node_.children)
            if (is_points(child) && !context_.report.full())
                is_good_ = read_points(child) && is_good_;
        if (is_good_)
            refuse_missing();
        return is_good_ ? std::optional{std::move(bindings_)} : std::nullopt;
    }

private:
    std::optional<std::vector<Binding>> read_one()
    {
        const auto binding = read_binding(node_);
        if (!binding)
            return std::nullopt;
        return std::vector<Binding>(spots_.size(), *binding);
    }

    bool read_points(const kdl::Node& node)
    {
        if (!fits(node, points_form, context_.report) || !refuse_properties(node, context_.report))
            return false;
        const auto binding = read_binding(node);
        const Range numbers{point_numbers.low, static_cast<double>(spots_.size())};
        const auto first = read_whole_number(node.arguments.front(), numbers, context_.report);
        const auto last = node.arguments.size() == 1
                              ? first
                              : read_whole_number(node.arguments.back(), numbers, context_.report);
        if (!binding || !first || !last)
            return false;
        const SourceSpan place = span(node.name_span, node.arguments.back().place);
        if (*first > *last)
            return context_.report.error(place, "the first of these points comes behind the last",
                                         "exchange the numbers");
        for (int i = *first; i <= *last; ++i)
            if (!set(static_cast<std::size_t>(i - 1), *binding, place))
                return false;
        return true;
    }

    bool set(std::size_t point, const Binding& binding, SourceSpan place)
    {
        if (!bindings_[point].empty())
            return context_.report.error(place, "point " + std::to_string(point + 1) +
                                                    " has weights already, on " +
                                                    context_.report.line(places_[point]));
        bindings_[point] = binding;
        places_[point] = place;
        return true;
    }

    std::optional<Binding> read_binding(const kdl::Node& node)
    {
        std::vector<WeightedBone> weights;
        bool good = true;
        for (const kdl::Node& child : node.children)
            good = read_weight(child, weights) && good;
        if (node.children.size() > max_bones_at_point)
            good = context_.report.error(node.children[max_bones_at_point].name_span,
                                         "a point follows at most " + std::to_string(max_bones_at_point) +
                                             " bones");
        const auto is_heavy = [](const WeightedBone& bone) { return bone.weight > 0; };
        if (good && std::ranges::none_of(weights, is_heavy))
            good = context_.report.error(node.name_span, "these weights add up to nothing",
                                         "give a bone a weight above 0");
        return good ? std::optional{bound(std::move(weights))} : std::nullopt;
    }

    bool read_weight(const kdl::Node& node, std::vector<WeightedBone>& weights)
    {
        if (!fits(node, weight_form(node.name), context_.report) || !refuse_properties(node, context_.report))
            return false;
        const auto bone = read_bone_name(node.name, node.name_span, bones_, context_);
        const auto weight = read_number(node.arguments.front(), weights_range, context_.report);
        if (!bone || !weight)
            return false;
        if (std::ranges::find(weights, *bone, &WeightedBone::bone) != weights.end())
            return context_.report.error(node.name_span, in_quotes(node.name) + " has a weight already",
                                         "remove one of them");
        weights.push_back({*bone, *weight});
        return true;
    }

    void refuse_missing()
    {
        const auto missing = std::ranges::find_if(bindings_, &Binding::empty);
        if (missing == bindings_.end())
            return;
        const auto index = static_cast<std::size_t>(missing - bindings_.begin());
        const auto count = static_cast<std::size_t>(std::ranges::count_if(bindings_, &Binding::empty));
        is_good_ = context_.report.error(node_.name_span,
                                         points_text(count) + " without weights; the first is point " +
                                             std::to_string(index + 1) + ", at " + place_text(spots_[index]),
                                         "add points " + std::to_string(index + 1) + " { BONE WEIGHT }");
    }

    const kdl::Node& node_;
    const std::vector<Bone>& bones_;
    const std::vector<Vec2>& spots_;
    SceneContext& context_;
    std::vector<Binding> bindings_;
    std::vector<SourceSpan> places_;
    bool is_good_ = true;
};

}

std::optional<std::vector<Binding>> read_weights(const kdl::Node* weights, const Skeleton& skeleton,
                                                 const std::vector<std::size_t>& bones,
                                                 const std::vector<Vec2>& spots, SourceSpan place,
                                                 SceneContext& context)
{
    const BoneRegions regions{skeleton, bones};
    if (weights == nullptr) {
        auto bindings = weights_of_regions(regions, spots, Spread::by_distance, place, context);
        warn_of_overlapping_bones(skeleton.bones.bones, bindings, place, context);
        return bindings;
    }
    if (!fits(*weights, weights_form, context.report) || !refuse_properties(*weights, context.report))
        return std::nullopt;
    if (weights->arguments.empty() == weights->children.empty()) {
        context.report.error(weights->name_span, "weights are either a word or those of bones",
                             "write weights auto, weights mean, or weights { BONE WEIGHT }");
        return std::nullopt;
    }
    if (!weights->children.empty())
        return GivenWeights{*weights, skeleton.bones.bones, spots, context}.read();
    const auto spread = read_word(weights->arguments.front(), spreads, context.report);
    if (!spread)
        return std::nullopt;
    return weights_of_regions(regions, spots, *spread, place, context);
}

std::vector<NodeSchema> weights_schema()
{
    constexpr std::string_view bone = "bone of weights";
    return {{weights_name, weights_form, {ValueKind::one_of<spreads>()}, {}, {points_name, bone}},
            {points_name, points_form, {ValueKind::whole(point_numbers)}, {}, {bone}},
            {bone, weight_form("BONE"), {ValueKind::number(weights_range)}, {}, {}, true}};
}

}
