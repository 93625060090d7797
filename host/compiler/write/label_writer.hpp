#pragma once

#include "host/compiler/pack/byte_writer.hpp"
#include "host/compiler/pack/drawing_pool.hpp"
#include "host/scene/model.hpp"

#include <cstdint>

namespace kfast {

/// Appends a label (docs/format.md, "Labels"), whose drawings go to `drawings`.
void write_label(const scene::Label& label, DrawingPool& drawings, ByteWriter& bytes);

}
