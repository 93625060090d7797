#pragma once

#include "core/tracer.hpp"

#include <cstddef>

namespace kfast {

/// Bytes that the outlines of all live drawings that are seen take in an OutlineStore at the moment to which
/// the scene was moved, whatever comes: those of the worst drawings that were tried
/// (tests/host/compiler/live_outlines_test.cpp).
std::size_t live_outline_bytes(const SceneOnPanel& on_panel);

}
