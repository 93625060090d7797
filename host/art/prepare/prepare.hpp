#pragma once

#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"

#include <cstddef>

namespace kfast::art {

/// How far simplification may move anything visible, in canvas pixels.
inline constexpr double default_tolerance = 1.0 / 32;

/// Scales everything by a factor above 0: the canvas, positions, drawings, widths and bones.
void scale(Document& document, double factor);

/// Cuts every animation to the length of the scene: a key at its beginning and one at its end replace those
/// beyond, and what is between stays exactly as before. The same is done to spans in which nodes are visible,
/// and to markers; markers outside, and transitions between drawings of different form that begin before the
/// scene, are added to `losses`.
void crop(Document& document, Losses& losses);

/// Merges curves, and leaves out points and keys, as long as nothing visible moves by more than `tolerance`
/// at any time; what never changes loses its keys.
void simplify(Document& document, double tolerance);

/// This many different cubic eases leave room among the 255 pairs of laws that a scene can have, for
/// transitions that are divided when the text is written.
inline constexpr std::size_t max_eases = 160;

/// If a document has more different eases than that, rounds the controls of all of them to the finest of some
/// grids on which it does not, and adds a Loss.
void share_eases(Document& document, Losses& losses);

/// Removes what is never visible: outlines without extent that show no dot, shapes that draw nothing or have
/// neither fill nor line, what is always transparent or never shown, and groups of nothing else.
void drop_unseen(Document& document);

/// Leaves out segments of no length, makes lines of curves that are straight, and merges neighbouring
/// segments where all keys allow it. The number of segments is the same in all keys afterwards. Nothing is
/// done to a drawing whose keys have different forms, nor to one with a skin, which has weights for its
/// points.
void merge_curves(Shape& shape, double tolerance);

}
