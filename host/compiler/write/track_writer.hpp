#pragma once

#include "host/compiler/pack/beat_writer.hpp"
#include "host/compiler/pack/byte_writer.hpp"
#include "host/compiler/pack/law_table.hpp"
#include "host/scene/model.hpp"

#include <cstdint>
#include <vector>

namespace kfast {

/// When the keys of a track are on its `clock`, or of what is stored as one. Smooth ones have no laws.
ClockedBeats beats_of(const std::vector<scene::TrackKey>& keys, Clock clock, bool is_smooth, LawTable& laws);
std::vector<std::int32_t> values_of(const std::vector<scene::TrackKey>& keys);

/// The tracks of `item` without those that change nothing (docs/format.md, "Tracks"), beginning with their
/// number, and how a beam draws it; no bytes if nothing is left.
std::vector<std::byte> packed_tracks(const scene::Item& item, LawTable& laws);

}
