#include "host/scene/items/skeleton_reader.hpp"

#include "host/scene/context/limits.hpp"
#include "host/scene/items/drawing_reader.hpp"
#include "host/scene/skeleton/backbone_reader.hpp"
#include "host/schema/node_form.hpp"
#include "host/schema/property_rule.hpp"
#include "host/text/characters.hpp"
#include "host/text/number_text.hpp"
#include "host/words/synonyms.hpp"

#include <array>
#include <optional>
#include <string>
#include <utility>

namespace kfast::scene {
namespace {

constexpr NodeForm skeleton_form{skeleton_name, "skeleton { backbone X Y X Y …; width PIXELS }", 0, 0, true};
constexpr std::string_view backbone_name = "backbone";
constexpr std::array<std::string_view, 4> names_inside{backbone_name, "width", "left", "right"};

bool report_inside(const kdl::Node& node, SceneContext& context)
{
    if (is_side(node.name))
        return context.report.error(node.name_span, "this " + node.name + " has no backbone in front of it",
                                    "write it behind the backbone that it belongs to");
    return context.report.error(node.name_span, "a skeleton has no node " + in_quotes(node.name),
                                word_hint(node.name, names_inside));
}

/// The nodes that belong to each backbone. Nothing if a node belongs to none.
std::optional<std::vector<BackboneNodes>> sorted(const kdl::Node& skeleton, SceneContext& context)
{
    std::vector<BackboneNodes> backbones;
    bool is_valid = true;
    for (const kdl::Node& node : skeleton.children)
        if (node.name == backbone_name)
            backbones.push_back({.backbone = &node});
        else if (is_side(node.name) && !backbones.empty())
            is_valid = add_side(node, backbones.back(), context) && is_valid;
        else
            is_valid = report_inside(node, context);
    return is_valid ? std::optional{backbones} : std::nullopt;
}

/// Reads the skeletons of one object in the order of their times.
class SkeletonReader {
public:
    explicit SkeletonReader(SceneContext& context) : context_{context} {}

    std::optional<std::vector<Backbone>> read(const kdl::Node& node)
    {
        if (!fits(node, skeleton_form, context_.report) || !refuse_properties(node, context_.report))
            return std::nullopt;
        const auto nodes = sorted(node, context_);
        if (!nodes || !has_known_form(node, *nodes))
            return std::nullopt;
        return read_backbones(node, *nodes);
    }

private:
    bool has_known_form(const kdl::Node& node, const std::vector<BackboneNodes>& nodes)
    {
        const std::size_t count = nodes.size();
        if (count == 0)
            return context_.report.error(node.name_span, "this skeleton has no backbone",
                                         "write backbone X Y X Y … into it");
        if (count > max_backbones)
            return context_.report.error(nodes[max_backbones].backbone->name_span,
                                         "a skeleton has at most " + std::to_string(max_backbones) +
                                             " backbones");
        if (before_.empty() || count == before_.size())
            return true;
        return context_.report.error(node.name_span,
                                     "this skeleton has " + counted(count, "backbone") +
                                         ", the one before it " + std::to_string(before_.size()),
                                     "all skeletons of an object have the same number of backbones");
    }

    std::optional<std::vector<Backbone>> read_backbones(const kdl::Node& node,
                                                        const std::vector<BackboneNodes>& nodes)
    {
        std::vector<ReadBackbone> read;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (auto backbone = read_backbone(nodes[i], before_.empty() ? nullptr : &before_[i], context_))
                read.push_back(std::move(*backbone));
        if (read.size() < nodes.size() || !has_capacity(node, read))
            return std::nullopt;
        std::vector<Backbone> backbones;
        backbones.reserve(read.size());
        for (const ReadBackbone& each : read)
            backbones.push_back(each.backbone);
        before_ = std::move(read);
        return backbones;
    }

    bool has_capacity(const kdl::Node& node, const std::vector<ReadBackbone>& backbones)
    {
        std::size_t points = 1;
        std::size_t segments = 0;
        for (const ReadBackbone& each : backbones) {
            points += 3 * each.backbone.nodes.size();
            segments += each.backbone.nodes.size() - 1;
        }
        if (segments > max_backbone_segments)
            return context_.report.error(node.name_span,
                                         "the backbones of this skeleton have " + std::to_string(segments) +
                                             " segments between their nodes, more than " +
                                             std::to_string(max_backbone_segments),
                                         "use fewer nodes");
        return take_points(points, node.name_span, context_);
    }

    SceneContext& context_;
    std::vector<ReadBackbone> before_; ///< of the skeleton before; empty before the first
};

}

std::vector<BackboneKey> read_skeletons(std::span<const ItemKey> keys, SceneContext& context)
{
    SkeletonReader skeletons{context};
    std::vector<BackboneKey> read;
    for (const ItemKey& key : keys) {
        if (key.skeleton == nullptr || context.report.full())
            continue;
        if (auto backbones = skeletons.read(*key.skeleton))
            read.push_back({.time = key.time,
                            .laws = key.laws.of_axes(),
                            .backbones = std::move(*backbones),
                            .place = key.place});
    }
    if (!read.empty())
        read.back().laws = {};
    return read;
}

NodeSchema skeleton_schema()
{
    return {skeleton_name, skeleton_form, {}, {}, {names_inside.begin(), names_inside.end()}};
}

}
