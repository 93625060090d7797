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

/// A backbone as it was read, and its width at each node, if its outline was given by widths.
struct ReadBackbone {
    Backbone backbone;
    std::vector<double> widths;
};

/// Adds what `node`, a width or a left or right side, says about the backbone. Returns false, which is
/// reported, if it has one already.
bool add_side(const kdl::Node& node, BackboneNodes& nodes, SceneContext& context);
bool is_side(std::string_view name);

/// Nothing if the backbone is invalid, which is reported. `before` is the same backbone in the
/// skeleton before this one, if there is one: it sets the number of nodes, and the widths if this one
/// has none.
std::optional<ReadBackbone> read_backbone(const BackboneNodes& nodes, const ReadBackbone* before,
                                          SceneContext& context);

/// The schema of a backbone, and of what gives its width.
std::vector<NodeSchema> backbone_schema();

}
