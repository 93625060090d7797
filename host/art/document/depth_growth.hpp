#pragma once

#include "host/art/document/extent.hpp"

namespace kfast::art {

/// Whether anything lies in front of the canvas or behind it, or turns out of it.
bool has_depth(const Document& document);

/// By how much the perspective makes motions larger at most, those towards the viewer included; at least 1.
/// `all` is what the document has before its perspective.
double perspective_scale_factor(const Document& document, const Extent& all);

}
