#pragma once

#include "host/scene/model.hpp"

#include <optional>
#include <vector>

namespace kfast {

/// A drawing of an object that bones deform, as it is stored.
struct SkinnedDrawing {
    scene::Drawing drawing;
    std::optional<scene::Drawing> at_rest; ///< of the same structure, if it is not the drawing itself
    std::vector<scene::Binding> bindings;  ///< of each point

    const scene::Drawing& rest() const { return at_rest ? *at_rest : drawing; }
};

/// `first` is the drawing that is bound by `bindings`, and `drawing` is empty or has as many strokes. If the
/// two differ, both are divided by the rules of core/pose/equalize.hpp, and points that are added to the
/// first mix the bindings of their neighbours. Nothing if that takes more points than a drawing holds.
std::optional<SkinnedDrawing> skinned_drawing(const scene::Drawing& first,
                                              const std::vector<scene::Binding>& bindings,
                                              const scene::Drawing& drawing);

}
