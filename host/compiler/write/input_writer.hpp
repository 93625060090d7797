#pragma once

#include "host/compiler/pack/byte_writer.hpp"
#include "host/compiler/pack/drawing_pool.hpp"
#include "host/scene/model.hpp"

#include <vector>

namespace kfast {

/// Appends the inputs of a scene one after the other (docs/format.md, "Inputs"); their drawings are put into
/// `drawings`.
void write_inputs(const std::vector<scene::Input>& inputs, DrawingPool& drawings, ByteWriter& bytes);

}
