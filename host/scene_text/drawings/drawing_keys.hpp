#pragma once

#include "host/art/document/document.hpp"
#include "host/scene/model.hpp"
#include "host/scene_text/values/stored_keys.hpp"

#include <vector>

namespace kfast::scene_text {

using DrawingKeys = std::vector<StoredKey<art::Drawing>>;

/// The drawings of a shape with all of their points where they are stored.
DrawingKeys drawing_keys(const art::Shape& shape, std::int32_t length);

/// The pivot that an object has if it does not say one: the middle of the first drawing that is not empty.
scene::Point default_pivot(const DrawingKeys& keys);

}
