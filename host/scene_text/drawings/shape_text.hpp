#pragma once

#include "host/art/geometry/drawing.hpp"

#include <string>

namespace kfast::scene_text {

/// With all of its points where they are stored, held within the range of coordinates.
art::Drawing on_grid(const art::Drawing& drawing);

/// The data of a path, in lines if it is long.
std::string path_data(const scene::Outline& outline);

}
