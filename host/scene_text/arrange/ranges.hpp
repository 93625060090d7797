#pragma once

#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"

#include <vector>

namespace kfast::scene_text {

/// Lets numbers lie within what scenes have: what is drawn too large is drawn smaller and grows, what is
/// drawn too small for its growth is drawn larger, and what goes too far goes in a group that grows. Returns
/// the greatest coordinate, in pixels, that there would be without such groups.
double fit_ranges(std::vector<art::Node>& nodes);

/// Likewise without groups. What is still beyond is held there when it is written, which is a loss. Returns
/// the greatest coordinate that there would be otherwise.
double hold_in_ranges(std::vector<art::Node>& nodes, art::Losses& losses);

}
