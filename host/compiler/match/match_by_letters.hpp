#pragma once

#include "host/compiler/match/match_by_length.hpp"
#include "host/scene/model.hpp"

#include <optional>

namespace kfast {

/// Two drawings of texts that equalization (core/pose/equalize.hpp) pairs letter by letter, in their order,
/// and in each letter stroke by stroke, whose points match by length. What has no partner, a stroke or a
/// letter, is drawn together to a point in the other drawing: a letter to its own centre, a stroke to that of
/// the other letter; if `is_stroked`, to the end of what stands before it, where a dot is not seen.
///
/// None if either would have more than kfb::max_drawing_points.
std::optional<MatchedDrawings> match_by_letters(const scene::Key& a, const scene::Key& b, bool is_stroked);

/// The drawings of the tween from `key` to `next`, matched as the first one says. None as above.
std::optional<MatchedDrawings> matched_drawings(const scene::Key& key, const scene::Key& next,
                                                bool is_stroked);

}
