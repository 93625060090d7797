#pragma once

#include "host/art/document/document.hpp"

#include <optional>

namespace kfast::scene_text {

/// How far the viewer of a scene is, in pixels: nothing where no depth is seen. Without a camera in the
/// document, what turns in space is looked at from as far as there is, so that it grows with no nearness.
std::optional<std::size_t> camera_of(const art::Document& document);

}
