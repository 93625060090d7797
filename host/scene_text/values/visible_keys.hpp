#pragma once

#include "host/art/document/document.hpp"
#include "host/scene_text/values/stored_keys.hpp"

#include <vector>

namespace kfast::scene_text {

/// When a node is seen, in a scene that is `length` ticks long: begins at 0.
std::vector<StoredKey<bool>> visible_keys(const std::vector<art::Span>& shown, std::int32_t length);

}
