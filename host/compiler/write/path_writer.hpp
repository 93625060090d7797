#pragma once

#include "host/compiler/pack/byte_writer.hpp"
#include "host/compiler/pack/drawing_pool.hpp"
#include "host/scene/model.hpp"
#include "host/text/diagnostic.hpp"

namespace kfast {

/// Appends the path that `item` follows, if it has one (docs/format.md, "Tracks"), its curves divided so that
/// the core can go along it evenly. One that is too long for the format is an error.
void write_path(const scene::Item& item, DrawingPool& drawings, ByteWriter& bytes, Diagnostics& diagnostics);

}
