#pragma once

#include "host/preview/board/standalone_player.hpp"
#include "host/preview/overlay/layer_probe.hpp"

#include <cstdint>
#include <optional>

namespace kfast {

/// Tells which item paints a pixel.
class PaintedItems final : public StandalonePlayer {
public:
    /// `scene`'s bytes must outlive it.
    PaintedItems(const SceneView& scene, Size panel, Fit fit);

    /// The path (core/scene/item_view.hpp) of the topmost item that covers at least half of a pixel at a
    /// moment; if there is none, of the topmost that touches it.
    std::optional<std::uint32_t> path_at(Time moment, int x, int y);

private:
    LayerProbe probe_;
};

}
