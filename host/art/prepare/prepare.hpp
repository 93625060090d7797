#pragma once

#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"

#include <cstddef>

namespace kfast::art {

/// How far simplification may move anything that is seen, in canvas pixels.
inline constexpr double default_tolerance = 1.0 / 32;

/// Makes everything larger by a factor above 0: the canvas, places, drawings, widths and bones.
void scale(Document& document, double factor);

/// Cuts every animation to the length of the scene: a key at its beginning and one at its end take the place
/// of those beyond, and what lies between goes exactly as before. So are spans in which nodes are seen, and
/// markers; markers that lie outside, and ways between drawings of different form that begin before the
/// scene, are added to `losses`.
void crop(Document& document, Losses& losses);

/// Merges curves, and leaves out points and keys, as long as nothing that is seen moves by more than
/// `tolerance` at any time; what never changes loses its keys.
void simplify(Document& document, double tolerance);

/// So many different cubic eases leave room among the 255 pairs of laws that a scene can have, for ways that
/// are divided when the text is written.
inline constexpr std::size_t max_eases = 160;

/// If a document has more different eases than that, rounds the controls of all of them to the finest of some
/// grids on which it has not, and adds a Loss.
void share_eases(Document& document, Losses& losses);

/// Takes out what is never seen: outlines without extent that show no dot, shapes that draw nothing or have
/// neither fill nor line, what is always transparent or never shown, and groups of nothing else.
void drop_unseen(Document& document);

/// Leaves out segments of no length, makes lines of curves that are straight, and merges neighbouring
/// segments where all keys allow it. The number of segments is the same in all keys afterwards. Nothing is
/// done to a drawing whose keys have different forms, nor to one with a skin, which has weights for its
/// points.
void merge_curves(Shape& shape, double tolerance);

}
