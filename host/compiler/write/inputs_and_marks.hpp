#pragma once

#include "host/compiler/pack/byte_writer.hpp"
#include "host/compiler/pack/drawing_pool.hpp"
#include "host/scene/model.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace kfast {

/// Appends a name of at most 255 bytes as the core's read_name() reads it.
inline void write_name(std::string_view name, ByteWriter& bytes)
{
    bytes.u8(static_cast<std::uint32_t>(name.size()));
    bytes.append(std::as_bytes(std::span{name}));
}

/// Appends the inputs of a scene one after the other (docs/format.md, "Inputs"); their drawings are put into
/// `drawings`.
void write_inputs(const std::vector<scene::Input>& inputs, DrawingPool& drawings, ByteWriter& bytes);

/// Appends the clocks, clips and events of `scene` (docs/format.md, "Marks").
void write_marks(const scene::Scene& scene, ByteWriter& bytes);

}
