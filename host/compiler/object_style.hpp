#pragma once

#include "core/item_view.hpp"
#include "host/scene/model.hpp"

#include <vector>

namespace kfast {

/// How `object`, with `tracks` and enlarged by at most `scale`, is painted. Its arcs have as many pieces as
/// keep them within 1/32 px wherever its stroke is widest, but at most kfb::max_arc_pieces.
ObjectStyle object_style(const scene::Object& object, const std::vector<scene::Track>& tracks, double scale);

}
