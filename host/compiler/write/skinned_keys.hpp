#pragma once

#include "host/compiler/write/key_writer.hpp"
#include "host/scene/model.hpp"

namespace kfast {

/// As packed_keys(), of an object that bones carry. A drawing that takes more points at rest than a drawing
/// holds is an error at its key.
PackedKeys packed_skinned_keys(const scene::Object& object, LawTable& laws, DrawingPool& drawings,
                               Diagnostics& diagnostics);

}
