#pragma once

#include "host/art/document/document.hpp"
#include "host/scene_text/values/stored_keys.hpp"
#include "host/scene_text/values/writing.hpp"

#include <string>
#include <vector>

namespace kfast::scene_text {

using DashKeys = std::vector<StoredKey<std::string>>;

/// The keys of the lengths of dashes, as texts: "9 5". At least one. Keys of a scene set all lengths by one
/// law, so that lengths that go by different ones are sampled. Where a moving pattern comes to more dashes
/// than a player draws, its lengths are 0 at that key, which is a whole line.
DashKeys dash_keys(const art::Shape& shape, const Writing& writing);

}
