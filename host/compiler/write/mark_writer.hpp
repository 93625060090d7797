#pragma once

#include "host/compiler/pack/byte_writer.hpp"
#include "host/scene/model.hpp"

namespace kfast {

/// Appends the clips and events of `scene` (docs/format.md, "Marks").
void write_marks(const scene::Scene& scene, ByteWriter& bytes);

}
