#pragma once

#include <cstdint>

namespace kfast::bench {

/// Fills what is free of the stack, so that used_stack() can tell how deep it has been since.
void paint_stack();
/// In bytes.
std::uint32_t used_stack();

}
