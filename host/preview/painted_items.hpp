#pragma once

#include "host/preview/told_player.hpp"

#include <cstdint>
#include <optional>
#include <vector>

namespace kfast {

/// Tells which item paints a pixel.
class PaintedItems final : public ToldPlayer {
public:
    /// `scene`'s bytes must outlive it.
    PaintedItems(const SceneView& scene, Size panel, Fit fit);

    /// The path (core/item_path.hpp) of the topmost item that covers at least half of a pixel at a moment; if
    /// there is none, of the topmost that touches it.
    std::optional<std::uint32_t> path_at(Time moment, int x, int y);

private:
    int level_at(const PaintStep& step, int x, int y);

    std::vector<std::int32_t> cells_; ///< of a row
};

}
