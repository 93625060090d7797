#pragma once

#include "host/art/document/document.hpp"
#include "host/art/geometry/drawing.hpp"
#include "host/scene/model.hpp"
#include "host/scene_text/values/stored_keys.hpp"

#include <string>
#include <vector>

namespace kfast::scene_text {

/// The drawing with all of its points rounded as they are stored, clamped to the range of coordinates.
art::Drawing on_grid(const art::Drawing& drawing);

/// The data of a path, in lines if it is long.
std::string path_data(const scene::Outline& outline);

using DrawingKeys = std::vector<StoredKey<art::Drawing>>;

/// The drawings of a shape with all of their points rounded as they are stored.
DrawingKeys drawing_keys(const art::Shape& shape, std::int32_t length);

/// The pivot that an object has by default: the middle of the first drawing that is not empty.
scene::Point default_pivot(const DrawingKeys& keys);

}
