#pragma once

#include "host/art/animation/ease.hpp"

#include <string>

namespace kfast {

/// "constant", "hold", "ease-in-out", "bezier(0.42,0,0.58,1)": those laws of the scene language that
/// importers know. Throws CLI::ValidationError in the name of `option`.
art::Ease read_ease(const std::string& option, const std::string& text);

}
