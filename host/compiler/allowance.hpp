#pragma once

#include "host/compiler/item_writer.hpp"
#include "host/scene/model.hpp"
#include "host/text/diagnostic.hpp"

#include <cstdint>

namespace kfast {

/// Checks what the format limits of a whole scene: edges, items, and points in all keys together. Too much of
/// any is an error at the item with the largest share. Returns the edges; only meaningful without an error.
std::uint32_t check_allowances(const scene::Scene& scene, const NeedsOfObjects& needs,
                               Diagnostics& diagnostics);

}
