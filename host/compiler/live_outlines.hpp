#pragma once

#include "core/moment.hpp"
#include "core/tracer.hpp"

#include <cstddef>

namespace kfast {

/// Bytes that the outlines of all live drawings that are seen at `moment` take in an OutlineStore, whatever
/// is told: those of the worst drawings that were tried (tests/host/compiler/live_outlines_test.cpp).
std::size_t live_outline_bytes(const SceneOnPanel& on_panel, const Moment& moment);

}
