#pragma once

#include "host/compiler/pack/byte_writer.hpp"
#include "host/compiler/pack/key_time_writer.hpp"
#include "host/scene/model.hpp"

#include <vector>

namespace kfast {

/// Appends the skeletons (docs/format.md, "Bones").
void write_bones(const std::vector<scene::Bones>& skeletons, LawTable& laws, ByteWriter& bytes);

}
