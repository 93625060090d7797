#pragma once

#include "host/art/budget.hpp"
#include "host/art/geometry/drawing.hpp"
#include "host/svg/parts/part.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace kfast::svg {

/// The corners of a drawing of one convex outline: each curve as 16 lines. Nothing for others.
std::optional<std::vector<scene::Vec2>> convex_corners(const art::Drawing& drawing);

/// Whether all of the points are in the area of a drawing, up to 1/100 px. Only for drawings of one convex
/// outline; for others it is false, since nothing needs more.
bool covers(const art::Drawing& area, std::span<const scene::Vec2> places);

/// The part of a filled drawing inside of a convex area with these corners, in either direction. Its outlines
/// are closed, and have lines along the edges of the area where something was cut off.
art::Drawing cut(const art::Drawing& drawing, std::span<const scene::Vec2> area);

/// Applies a clip to a part: removes what is outside of a convex area. Fills are cut; lines that cross the
/// edge of the area stay whole.
class Clip {
public:
    /// `area` is a drawing with convex_corners().
    Clip(const art::Drawing& area, art::Budget& budget) : area_{area}, budget_{budget} {}

    /// `affine`, from what is drawn of the part to the coordinates of the area, replaces its own. Returns
    /// false if nothing of it is left.
    bool apply(Part& part, const art::Affine& affine);

    /// Layers of the lines that stayed whole.
    const std::vector<std::string>& whole_lines() const { return whole_lines_; }

private:
    bool cut_fill(Part& part, const art::Affine& affine);

    const art::Drawing& area_;
    art::Budget& budget_;
    std::vector<std::string> whole_lines_;
};

}
