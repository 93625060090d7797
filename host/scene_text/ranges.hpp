#pragma once

#include "host/art/document.hpp"
#include "host/scene_text/arrange.hpp"

#include <vector>

namespace kfast::scene_text {

/// Lets all numbers lie within what scenes have: what is drawn too large is drawn smaller and grows, what is
/// drawn too small for its growth is drawn larger, and what goes too far goes in a group that grows. What is
/// still beyond is held there, which is a loss.
void fit_ranges(std::vector<art::Node>& nodes, const Arranging& arranging);

}
