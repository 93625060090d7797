#pragma once

#include "core/math/affine.hpp"
#include "core/math/point.hpp"
#include "core/math/projection.hpp"
#include "core/pose/scene_state.hpp"
#include "core/prepared/prepared_scene.hpp"
#include "core/scene/item_view.hpp"
#include "core/scene/scene_view.hpp"
#include "host/fit/target.hpp"
#include "host/player/word_block.hpp"
#include "host/preview/overlay/overlay.hpp"
#include "host/walk/every_item.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace kfast {

/// Where a preview shows a scene.
struct Viewport {
    SceneView scene;
    Size panel;
    Fit fit = Fit::contain;
    bool is_beam = false; ///< the panel is the screen of a vector display
    /// Sends what has changed to such a panel; none: previewed_board().
    std::optional<fit::Target> board = {};

    /// The panel on which the core poses the scene: for a beam one that represents its field.
    Size posed_panel() const;
    Fit posed_fit() const { return is_beam ? Fit::contain : fit; }
    /// From there to where it is seen.
    PanelSpot spot(Point posed) const;
};

/// An object, a text or a plot as it is seen at a time. All is valid during the visit alone.
struct SeenLeaf {
    const ItemView& item;
    const Node& node;   ///< the same
    const Space& space; ///< from its own coordinates to the panel
    const SceneTime& moment;
    std::uint32_t path; ///< core/scene/item_view.hpp
    /// Its number in SceneFile::item_names, the last one, after those of the groups and uses around it.
    std::span<const std::size_t> numbers;

    std::size_t number() const { return numbers.back(); }
};

/// A scene that is posed as a player poses it, for inspection rather than for painting.
class PosedScene : private WordBlock, public SceneState {
public:
    using Visit = std::function<void(const SeenLeaf&)>;

    /// `scene`'s bytes must outlive it.
    PosedScene(const SceneView& scene, Size panel, Fit fit);
    PosedScene(const PosedScene&) = delete;

    /// Poses the bones and calls visit() for each leaf that is visible at all, in the order of painting. A
    /// time outside of the scene is its beginning or its end.
    void visit(Time moment, const Visit& visit);

    /// The scene time at a time, as for a visit. Valid until an input is set.
    SceneTime at(Time moment);
    /// The item of that number in SceneFile::item_names; none if there is none.
    std::optional<ItemView> item(std::size_t number) const;

    /// The panel with the bones as at the last visit, and the backbones of the object that was traced last.
    using SceneState::on_panel;

private:
    std::map<const std::byte*, StoredItem> items_;
};

/// A bone where it is seen, on the panel.
struct SeenBone {
    Point origin;
    Point tip;
};

/// The bones of a skeleton, the way they are posed, seen through `space`. `skeleton` is its number in the
/// scene, which was visited.
std::vector<SeenBone> seen_bones(const PosedScene& scene, std::uint32_t skeleton, const Space& space);

/// A backbone and its outline where they are seen, on the panel: as many points of each, node by node.
struct SeenBackbone {
    std::vector<Point> nodes;
    std::vector<Point> left;
    std::vector<Point> right;
};

/// The backbones that deform an object at this time; none if none do. `scene` visits the leaf just now.
std::vector<SeenBackbone> seen_backbones(const PosedScene& scene, const SeenLeaf& leaf);

}
