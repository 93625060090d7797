#pragma once

#include "host/compiler/byte_writer.hpp"
#include "host/scene/model.hpp"

#include <vector>

namespace kfast {

/// Appends the inputs of a scene one after the other (docs/format.md, "Inputs").
void write_inputs(const std::vector<scene::Input>& inputs, ByteWriter& bytes);

}
