#include "host/svg/poses/pose_document.hpp"

#include "host/svg/elements/element_outlines.hpp"
#include "host/svg/parts/motion.hpp"
#include "host/svg/poses/moments.hpp"
#include "host/svg/poses/part_match.hpp"
#include "host/svg/poses/shape_keys.hpp"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <utility>

namespace kfast::svg {

namespace {

using art::Affine;

/// Deeper than this, groups are kept only if they do something: scenes nest at most 8.
constexpr int deepest_named = 4;

void add_ids(const Part& part, std::set<std::string_view>& ids)
{
    if (!part.id.empty())
        ids.insert(part.id);
    for (const Part& inner : part.parts)
        add_ids(inner, ids);
}

/// Whether an author named it, and it is not a shape in two parts.
bool is_named(const Part& part)
{
    return !is_shape(part.kind) && (!part.label.empty() || !is_made_up(part.id));
}

std::vector<const Part*> parts_of(const Moments& moments)
{
    std::vector<const Part*> parts;
    for (const Moment& moment : moments)
        parts.push_back(moment.part);
    return parts;
}

class NodeMaker {
public:
    NodeMaker(std::span<const Pose> poses, art::Budget& budget, art::Losses& losses)
        : budget_{budget}, losses_{losses}, ids_(poses.size())
    {
        for (std::size_t i = 0; i < poses.size(); ++i)
            add_ids(poses[i].root, ids_[i]);
    }

    void add(const Moments& moments, std::vector<art::Node>& nodes, int depth)
    {
        art::Budget::check_depth(depth);
        if (first_part(moments).is_group)
            add_group(moments, nodes, depth);
        else if (auto node = shape_node(moments, budget_, losses_))
            nodes.push_back(std::move(*node));
    }

private:
    void add_group(const Moments& moments, std::vector<art::Node>& nodes, int depth)
    {
        const Part& first = first_part(moments);
        const auto motion = motion_of(moments);
        const bool fades = std::ranges::any_of(
            moments, [](const Moment& moment) { return moment.part != nullptr && moment.part->opacity < 1; });
        const bool holds_several = first.parts.size() > 1;
        const bool is_kept =
            fades || motion || (is_named(first) && holds_several && depth > 0 && depth <= deepest_named);
        const Moments seen = is_kept ? present(moments) : moments;
        const auto folds = motion ? std::vector<Affine>(seen.size(), motion->at_rest) : ways(seen);
        if (!is_kept) {
            const std::size_t before = nodes.size();
            add_parts(seen, folds, nodes, depth);
            if (nodes.size() == before + 1 && is_named(first) && is_made_up(nodes.back().name))
                nodes.back().name = first.name; // its content has no better one
            return;
        }
        art::Group group;
        add_parts(seen, folds, group.nodes, depth);
        art::Node node;
        node.name = first.name;
        node.opacity = keyed(instants(seen), values_of(seen, [](const Part& part) { return part.opacity; }),
                             std::equal_to<>{}, budget_);
        if (group.nodes.empty() || (node.opacity.is_still() && node.opacity.value() <= 0))
            return;
        if (motion)
            node.transform = transform_of(*motion, seen, budget_);
        node.shown = spans(moments);
        node.content = std::move(group);
        nodes.push_back(std::move(node));
    }

    void add_parts(const Moments& groups, const std::vector<Affine>& folds, std::vector<art::Node>& nodes,
                   int depth)
    {
        const auto parts = parts_of(groups);
        const PartMatch match = matched(parts);
        if (match.reordered > 0)
            losses_.add({"other order of what lies over each other", first_part(groups).layer,
                         groups[match.reordered].instant.time, "the order of the first drawing"});
        for (const PartLane& lane : match.lanes) {
            Moments moments;
            for (std::size_t i = 0; i < lane.size(); ++i)
                moments.push_back({groups[i].instant, lane[i], folds[i], groups[i].pose});
            report_elsewhere(moments, groups);
            add(moments, nodes, depth + 1);
        }
    }

    /// Reports ids that are in another group there, and so are not found.
    void report_elsewhere(const Moments& moments, const Moments& groups)
    {
        const Part& part = first_part(moments);
        for (std::size_t i = 0; i < moments.size() && !part.id.empty(); ++i)
            if (moments[i].part == nullptr && groups[i].part != nullptr &&
                ids_[moments[i].pose].contains(part.id))
                losses_.add({"\"" + part.id + "\" lies in another group, or is of another kind", part.layer,
                             moments[i].instant.time, "it is a figure of its own there"});
    }

    art::Budget& budget_;
    art::Losses& losses_;
    std::vector<std::set<std::string_view>> ids_; ///< of each pose
};

}

std::vector<art::Node> nodes_of(std::span<const Pose> poses, art::Budget& budget, art::Losses& losses)
{
    Moments moments;
    for (std::size_t i = 0; i < poses.size(); ++i)
        moments.push_back({{poses[i].time, poses[i].ease}, &poses[i].root, {}, i});
    std::vector<art::Node> nodes;
    NodeMaker{poses, budget, losses}.add(moments, nodes, 0);
    return nodes;
}

namespace {

/// Whether the last pose looks like the first one.
bool closes(const std::vector<Pose>& poses)
{
    return poses.size() == 1 || looks_like(poses.front().root, poses.back().root);
}

Ending ending_of(const std::vector<Pose>& poses, Ending asked)
{
    if (asked != Ending::automatic)
        return asked;
    return closes(poses) ? Ending::repeat : Ending::ping_pong;
}

/// The last drawing is there for a frame, unless a loop goes on with one that looks the same.
double length_of(const std::vector<Pose>& poses, Ending ending)
{
    const bool goes_on = ending == Ending::back_to_first || (ending == Ending::repeat && closes(poses));
    return std::max(poses.back().time + (goes_on ? 0 : 1), 1.0);
}

Loop loop_of(Ending ending)
{
    if (ending == Ending::once)
        return Loop::once;
    return ending == Ending::ping_pong ? Loop::ping_pong : Loop::repeat;
}

void go_back_to_first(std::vector<Pose>& poses)
{
    const double last = poses.back().time;
    const double step = poses.size() > 1 ? last - poses[poses.size() - 2].time : 1;
    Pose again = poses.front();
    again.time = last + step;
    poses.push_back(std::move(again));
}

}

art::Document document_of(const Picture& canvas, std::vector<Pose> poses, const KeyOptions& options,
                          art::Budget& budget, art::Losses& losses)
{
    const Ending ending = ending_of(poses, options.ending);
    if (ending == Ending::back_to_first)
        go_back_to_first(poses);
    art::Document document;
    document.width = canvas.width;
    document.height = canvas.height;
    document.background = canvas.background;
    document.frame_rate = options.frame_rate;
    document.frames = length_of(poses, ending);
    document.loop = loop_of(ending);
    document.nodes = nodes_of(poses, budget, losses);
    return document;
}

}
