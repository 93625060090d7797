#pragma once

#include "core/player.hpp"
#include "core/raster/layer_row.hpp"
#include "host/preview/board/standalone_player.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace kfast {

/// Finds what single layers of a picture cover, whatever is above them.
class LayerProbe {
public:
    /// `player` must outlive it. It has computed a picture and must not draw meanwhile: the calls here would
    /// disturb it.
    explicit LayerProbe(Player& player) : player_{player} {}

    /// How much of a pixel of the panel the step of this number covers: 0 … raster::full_coverage.
    int coverage(std::size_t step, int x, int y);
    /// Whether it covers anything of the panel.
    bool covers_any(std::size_t step);

private:
    raster::Band first_band(raster::OutlineStore& outlines) const;
    int max_coverage(const raster::Band& band, std::size_t step, int row, int begin, int end);

    Player& player_;
    raster::CoverageSums sums_;
};

/// Finds which item paints a pixel.
class PaintedItems final : public StandalonePlayer {
public:
    /// `scene`'s bytes must outlive it.
    PaintedItems(const SceneView& scene, Size panel, Fit fit);

    /// The path (core/scene/item_view.hpp) of the topmost item that covers at least half of a pixel at a
    /// time; if there is none, of the topmost that touches it.
    std::optional<std::uint32_t> path_at(Time moment, int x, int y);

private:
    LayerProbe probe_;
};

}
