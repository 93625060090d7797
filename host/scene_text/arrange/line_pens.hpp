#pragma once

#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"

#include <vector>

namespace kfast::scene_text {

/// Lines of scenes are as wide in every direction: reports those whose pen becomes wider one way than the
/// other, by more than a twentieth, because what is around them grows unevenly or leans.
void report_bent_pens(const std::vector<art::Node>& nodes, art::Losses& losses);

}
