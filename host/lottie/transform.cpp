#include "host/lottie/shapes.hpp"

#include <nlohmann/json.hpp>

namespace kfast::lottie {

art::Transform read_transform(const Json&, const Reading&) { return {}; }

}
