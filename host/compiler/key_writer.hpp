#pragma once

#include "host/compiler/drawing_pool.hpp"
#include "host/compiler/law_table.hpp"
#include "host/scene/model.hpp"
#include "host/text/diagnostic.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kfast {

/// The keys of one object as the format has them.
struct PackedKeys {
    std::vector<std::byte> bytes;
    std::uint64_t points = 0; ///< as the format counts them: each drawing of each key has one more
};

/// Whether any way from a key of `object` to the next matches by length: then all of its keys have arrival
/// drawings.
bool has_arrivals(const scene::Object& object);

/// The keys of `object`, which is enlarged by at most `scale`. A way that takes more points than a drawing
/// holds is an error at its key.
PackedKeys packed_keys(const scene::Object& object, double scale, LawTable& laws, DrawingPool& drawings,
                       Diagnostics& diagnostics);

}
