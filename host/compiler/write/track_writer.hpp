#pragma once

#include "host/compiler/pack/byte_writer.hpp"
#include "host/compiler/pack/key_time_writer.hpp"
#include "host/scene/model.hpp"

#include <cstdint>
#include <vector>

namespace kfast {

/// The times of the keys of a track, or of what is stored as one, by its `driver`. Smooth ones have no laws.
DrivenKeyTimes key_times_of(const std::vector<scene::TrackKey>& keys, Driver driver, bool is_smooth,
                            LawTable& laws);
std::vector<std::int32_t> values_of(const std::vector<scene::TrackKey>& keys);

/// The tracks of `item` without those that change nothing (docs/format.md, "Tracks"), beginning with their
/// number, and how a beam draws it; no bytes if nothing is left.
std::vector<std::byte> packed_tracks(const scene::Item& item, LawTable& laws);

}
