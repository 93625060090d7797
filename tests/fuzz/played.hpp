#pragma once

#include <cstddef>
#include <span>

namespace kfast {

/// Any scene that is not refused can be read, and shown at every frame and between them, within the memory it
/// asks for; what breaks that is a finding of the fuzzer.
void play(std::span<const std::byte> bytes);

}
