#pragma once

#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"
#include "host/kdl/document.hpp"

#include <cstdint>
#include <vector>

namespace kfast::scene_text {

/// An event for each marker, and a clip for each that lasts, in the order of their times.
std::vector<kdl::Node> marker_nodes(const art::Document& document, std::int32_t length, art::Losses& losses);

}
