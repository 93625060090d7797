#pragma once

#include "host/art/budget.hpp"
#include "host/svg/parts/part.hpp"

#include <string>
#include <vector>

namespace kfast::svg {

/// What a clip does to a part: takes away what lies outside of a convex area. Fills are cut; lines that reach
/// over the edge of the area stay whole.
class Clip {
public:
    /// `area` is a drawing with convex_corners().
    Clip(const art::Drawing& area, art::Budget& budget) : area_{area}, budget_{budget} {}

    /// `affine`, from what is drawn of the part to the coordinates of the area, takes the place of its own.
    /// False where nothing of it is left.
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
