#pragma once

#include "host/compiler/byte_writer.hpp"
#include "host/scene/model.hpp"

namespace kfast {

/// Appends `drawing` as the core's PackedDrawing reads it (docs/format.md, "Drawings").
void pack_drawing(const scene::Drawing& drawing, ByteWriter& bytes);

}
