#pragma once

#include <cstdint>

/// The debugger's door to the host (Arm's semihosting), which QEMU answers.
namespace kfast::bench::semihosting {

void write(const char* text);
void write(std::uint32_t number);
[[noreturn]] void exit(int code);

}
