#pragma once

#include "host/compiler/carry/deformed_tweens.hpp"
#include "host/compiler/pack/byte_writer.hpp"
#include "host/compiler/pack/drawing_pool.hpp"
#include "host/compiler/pack/key_time_writer.hpp"
#include "host/scene/model.hpp"
#include "host/text/diagnostic.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kfast {

/// The keys of one object as the format has them.
struct PackedKeys {
    std::vector<std::byte> bytes;
    std::uint32_t unit_bits = 0; ///< see KeyTweens
};

/// Whether tweens from a key of `object` to the next are written with both of their ends: all of them, if
/// one matches by length, or if backbones deform them.
bool has_arrivals(const scene::Object& object);

/// The keys of `object` and the tweens between them, as they are stored. Reports what packed_keys() reports.
KeyTweens key_tweens(const scene::Object& object, Diagnostics& diagnostics);

/// The keys of `object`. A tween that needs more points than a drawing can have is an error at its key,
/// points that backbones do not reach are a warning there.
PackedKeys packed_keys(const scene::Object& object, LawTable& laws, DrawingPool& drawings,
                       Diagnostics& diagnostics);

/// Like packed_keys(), for an object that bones deform. A drawing that needs more points at rest than a
/// drawing can have is an error at its key.
PackedKeys packed_skinned_keys(const scene::Object& object, LawTable& laws, DrawingPool& drawings,
                               Diagnostics& diagnostics);

/// Appends what an item says of its backbones (docs/format.md, "Backbones"), of which `object` has some.
void write_backbones(const scene::Object& object, std::uint32_t unit_bits, LawTable& laws,
                     DrawingPool& drawings, ByteWriter& bytes);

}
