#pragma once

#include "host/art/animation/ease.hpp"

#include <string>

namespace kfast::scene_text {

/// "constant", "hold", "ease-in" or "bezier(0.1,0,0.9,1)"; control points beyond what laws have are held at
/// the ends of that.
std::string law_of(const art::Ease& ease);

}
