#pragma once

#include "host/compiler/byte_writer.hpp"
#include "host/compiler/law_table.hpp"
#include "host/scene/model.hpp"

#include <vector>

namespace kfast {

/// The keys of a track, or what is stored as one. Smooth ones have no laws.
std::vector<std::byte> packed_keys(const std::vector<scene::TrackKey>& keys, bool is_smooth, LawTable& laws);

/// The tracks of `item` without those that change nothing (docs/format.md, "Tracks"), beginning with their
/// number; no bytes if none is left.
std::vector<std::byte> packed_tracks(const scene::Item& item, LawTable& laws);

}
