#pragma once

#include "host/art/document/document.hpp"

#include <cstdint>
#include <vector>

namespace kfast::scene_text {

/// Leaves out what is never seen in a scene of that many ticks: fills and lines without opacity or width,
/// shapes without drawings, groups without nodes.
void drop_unseen(std::vector<art::Node>& nodes, std::int32_t length);

/// Makes neighbours that are written as one group in several parts one group.
void join_parts(std::vector<art::Node>& nodes);

}
