#pragma once

#include "core/pixel/paint_style.hpp"
#include "host/art/geometry/affine.hpp"
#include "host/art/geometry/drawing.hpp"
#include "host/svg/style/colour.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace kfast::svg {

/// How a line is broken, in the units of the drawing.
struct Dashes {
    std::vector<double> lengths; ///< of dashes and gaps alternately; none: no dashes
    double offset = 0;
    friend bool operator==(const Dashes&, const Dashes&) = default;
};

/// What a line is drawn with.
struct Pen {
    Ink ink;
    double width = 1; ///< in the units of the drawing
    Cap cap = Cap::butt;
    Join join = Join::miter;
    double miter_limit = 4;
    bool keeps_width = false; ///< the width is in pixels of the canvas, however the drawing is scaled
    Dashes dashes = {};
    friend bool operator==(const Pen&, const Pen&) = default;
};

/// An element that is drawn, with all that it inherits resolved: a group, or a shape with a fill or a line.
struct Part {
    std::string id;    ///< by which it is found in other drawings; may be empty
    std::string label; ///< Inkscape's; may be empty
    std::string kind;  ///< name of the element
    std::string name;  ///< what the scene calls it
    std::string layer; ///< of losses: names from the outermost
    art::Affine own;   ///< of its transform
    double opacity = 1;

    bool is_group = false;
    std::vector<Part> parts; ///< of a group, the first is the lowest

    art::Drawing drawing; ///< of a shape
    FillRule rule = FillRule::nonzero;
    std::optional<Ink> fill;
    std::optional<Pen> pen;
};

/// The corners of a box around something.
struct Box {
    scene::Vec2 min;
    scene::Vec2 max;
    scene::Vec2 centre() const { return 0.5 * (min + max); }
};

std::array<scene::Vec2, 4> corners_of(const Box& box);
art::Drawing outline_of(const Box& box);

art::Drawing seen_through(const art::Affine& affine, const art::Drawing& drawing);

/// The box around all that is drawn of a part, transformed by `affine`, which replaces its own. Nothing if
/// nothing is drawn.
std::optional<Box> box_of(const Part& part, const art::Affine& affine);

/// The same, but lines count with half of their width.
std::optional<Box> box_with_lines(const Part& part, const art::Affine& affine);

/// Makes a group of a shape with a fill and a line: a shape has one drawing, and its line over its fill.
void split_line(Part& part, const art::Drawing& line, bool below);

/// Whether both look the same, whatever their elements are called.
bool looks_like(const Part& left, const Part& right);

}
