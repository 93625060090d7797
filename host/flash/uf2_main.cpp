// uf2 IMAGE ADDRESS OUT.uf2    For the build of device images: a file to drop on the drive of a boot loader.

#include "host/file/atomic_file.hpp"
#include "host/file/input_file.hpp"
#include "host/flash/uf2.hpp"

#include <array>
#include <cstdio>
#include <exception>
#include <span>
#include <stdexcept>
#include <string>

namespace {

constexpr kfast::InputKind image_input{"image", "a .bin file", "build it again"};

std::uint32_t address_in(const std::string& text)
{
    std::size_t end = 0;
    const unsigned long long address = std::stoull(text, &end, 0);
    if (end != text.size() || address > 0xFFFF'FFFF)
        throw std::invalid_argument{text + " is no address of 32 bits"};
    return static_cast<std::uint32_t>(address);
}

}

int main(int count, char** arguments)
try {
    if (count != 4) {
        std::fputs("usage: uf2 IMAGE ADDRESS OUT.uf2\n", stderr);
        return 2;
    }
    const std::string image = kfast::read_input(arguments[1], image_input);
    const auto bytes = std::as_bytes(std::span{image});
    const std::array regions{kfast::FlashRegion{address_in(arguments[2]), {bytes.begin(), bytes.end()}}};
    kfast::write_file(arguments[3], kfast::uf2_of(regions));
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "uf2: %s\n", error.what());
    return 1;
}
