#pragma once

#include "core/math/affine.hpp"
#include "core/math/point.hpp"
#include "core/scene/scene_view.hpp"
#include "host/fit/target.hpp"
#include "host/preview/overlay/overlay.hpp"

#include <optional>

namespace kfast {

/// Where a preview shows a scene.
struct Viewport {
    SceneView scene;
    Size panel;
    Fit fit = Fit::contain;
    bool is_beam = false; ///< the panel is the screen of a vector display
    /// That sends what has changed to such a panel; none: previewed_board().
    std::optional<fit::Target> board = {};

    /// The panel on which the core poses the scene: for a beam one that stands for its field.
    Size posed_panel() const;
    Fit posed_fit() const { return is_beam ? Fit::contain : fit; }
    /// From there to where it is seen.
    PanelSpot spot(Point posed) const;
};

}
