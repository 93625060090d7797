#pragma once

#include "host/art/document/document.hpp"
#include "host/kdl/document.hpp"
#include "host/scene/model.hpp"
#include "host/scene_text/values/stored_keys.hpp"
#include "host/scene_text/values/writing.hpp"

#include <optional>
#include <string_view>
#include <vector>

namespace kfast::scene_text {

using NumberKeys = std::vector<StoredKey<std::int32_t>>;

/// Adds `quantity` to an item: as a property if it is constant, unless it is `ordinary`, or else as a
/// track.
void add_quantity(kdl::Node& item, std::string_view quantity, const NumberKeys& keys, const Grid& grid,
                  std::optional<std::int32_t> ordinary);

/// Adds the position, rotation, scale and opacity of a node. `pivot` is the default of the item, in 1/16
/// px.
void add_transform(kdl::Node& item, const art::Transform& transform, const art::Channel& opacity,
                   scene::Point pivot, const Writing& writing);

}
