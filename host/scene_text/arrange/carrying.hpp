#pragma once

#include "host/art/document/document.hpp"
#include "host/art/geometry/affine.hpp"

namespace kfast::scene_text {

/// Whether a node can look as if `affine` acted on it, by changing numbers alone.
bool can_take(const art::Affine& affine, const art::Node& node);

/// Makes it look that way.
void take(const art::Affine& affine, art::Node& node);

/// The same for what is inside of the node: points, or nodes.
bool content_can_take(const art::Affine& affine, const art::Node& node);
void content_takes(const art::Affine& affine, art::Node& node);

}
