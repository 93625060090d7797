#pragma once

#include "core/math/projection.hpp"
#include "core/pose/scene_state.hpp"
#include "core/prepared/prepared_scene.hpp"
#include "core/scene/item_view.hpp"
#include "host/player/word_block.hpp"
#include "host/walk/stored_items.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>

namespace kfast {

/// An object, a text or a plot as it is seen at a moment. All is valid during the visit alone.
struct SeenLeaf {
    const ItemView& item;
    const Node& node;   ///< the same
    const Space& space; ///< from its own coordinates to the panel
    const SceneTime& moment;
    std::uint32_t path; ///< core/scene/item_view.hpp
    /// Its place in SceneFile::item_names, the last one, after those of the groups and uses around it.
    std::span<const std::size_t> numbers;

    std::size_t number() const { return numbers.back(); }
};

/// A scene that is posed as a player poses it, to be looked at rather than painted.
class PosedScene : private WordBlock, public SceneState {
public:
    using Visit = std::function<void(const SeenLeaf&)>;

    /// `scene`'s bytes must outlive it.
    PosedScene(const SceneView& scene, Size panel, Fit fit);
    PosedScene(const PosedScene&) = delete;

    /// Poses the bones and calls visit() for each leaf that is seen at all, in the order of painting. A
    /// moment outside of the scene is its beginning or its end.
    void visit(Time moment, const Visit& visit);

    /// Where all clocks stand at a moment, as for a visit. Valid until an input is set.
    SceneTime at(Time moment);
    /// Of that place in SceneFile::item_names; nothing if there is none.
    std::optional<ItemView> item(std::size_t number) const;

    /// With the bones as at the last visit, and the backbones of the object that was traced last.
    using SceneState::on_panel;

private:
    std::map<const std::byte*, StoredItem> items_;
};

}
