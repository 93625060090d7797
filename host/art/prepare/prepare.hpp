#pragma once

#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"
#include "host/art/prepare/tolerance.hpp"

namespace kfast::art {

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

}
