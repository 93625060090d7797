#pragma once

#include "host/kdl/document.hpp"
#include "host/scene/model.hpp"
#include "host/scene/reading.hpp"

#include <optional>
#include <string_view>

namespace kfast::scene {

inline constexpr std::string_view key_name = "key";

/// Nothing when it cannot be said when the key is, which is reported like everything else.
std::optional<Key> read_key(const kdl::Node& node, Reading& reading);

/// Where a key names a law, if it does.
std::optional<Place> law_place(const kdl::Node& node);

}
