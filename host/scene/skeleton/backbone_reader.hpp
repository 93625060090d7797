#pragma once

#include "host/geometry/outline.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/context/scene_context.hpp"
#include "host/scene/model.hpp"
#include "host/schema/node_form.hpp"

#include <optional>
#include <vector>

namespace kfast::scene {

/// The nodes of a skeleton that say what one backbone is; all but the first may be missing.
struct BackboneNodes {
    const kdl::Node* backbone = nullptr;
    const kdl::Node* width = nullptr;
    const kdl::Node* left = nullptr;
    const kdl::Node* right = nullptr;
};

/// A backbone as it was read, and how wide it is at each node, if that is how it was given its outline.
struct ReadBackbone {
    Backbone backbone;
    std::vector<double> widths;
};

/// Whether it adds what `node`, a width or a left or right side, says of the backbone; reports it if not.
bool add_side(const kdl::Node& node, BackboneNodes& nodes, SceneContext& context);
bool is_side(std::string_view name);

/// Nothing when the backbone is wrong, which is reported. `before` is the same backbone in the skeleton
/// before this one, if there is one: it gives the number of nodes, and the widths to a backbone that has
/// none.
std::optional<ReadBackbone> read_backbone(const BackboneNodes& nodes, const ReadBackbone* before,
                                          SceneContext& context);

/// Of a backbone, and of what says how wide it is.
std::vector<NodeSchema> backbone_words();

}
