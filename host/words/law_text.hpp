#pragma once

#include "core/time/velocity_law.hpp"

#include <string>

namespace kfast {

/// As the scene language writes it: "accelerate", "steps(4)", "bezier(0.42,0,0.58,1)".
std::string law_text(const VelocityLaw& law);

}
