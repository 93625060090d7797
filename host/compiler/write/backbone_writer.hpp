#pragma once

#include "host/compiler/pack/byte_writer.hpp"
#include "host/compiler/pack/drawing_pool.hpp"
#include "host/compiler/pack/law_table.hpp"
#include "host/scene/model.hpp"

#include <cstdint>

namespace kfast {

/// Appends what an item says of its backbones (docs/format.md, "Backbones"), of which `object` has some.
void write_backbones(const scene::Object& object, std::uint32_t unit_bits, LawTable& laws,
                     DrawingPool& drawings, ByteWriter& bytes);

}
