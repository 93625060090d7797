// boot_block CODE OUT.S    For the build of device images: makes assembly of a boot block from its code.

#include "host/file/atomic_file.hpp"
#include "host/file/input_file.hpp"
#include "host/flash/boot_checksum.hpp"

#include <array>
#include <cstdio>
#include <exception>
#include <span>
#include <string>

namespace {

constexpr kfast::InputKind code_input{"boot block", "a .bin file", "build it again"};

std::string assembly_of(std::span<const std::byte> block)
{
    std::string text = "    .section .boot_block, \"a\"\n";
    for (const std::byte byte : block)
        text += "    .byte " + std::to_string(std::to_integer<int>(byte)) + "\n";
    return text;
}

}

int main(int count, char** arguments)
try {
    if (count != 3) {
        std::fputs("usage: boot_block CODE OUT.S\n", stderr);
        return 2;
    }
    const std::string code = kfast::read_input(arguments[1], code_input);
    const std::string assembly = assembly_of(kfast::with_boot_checksum(std::as_bytes(std::span{code})));
    kfast::write_file(arguments[2], std::as_bytes(std::span{assembly}));
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "boot_block: %s\n", error.what());
    return 1;
}
