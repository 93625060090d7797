#include "tests/fuzz/played.hpp"
#include "tests/fuzz/sealed.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

using namespace kfast;

/// Any bytes at all, as they are and sealed. How many they are decides where and how they are played.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto bytes = std::as_bytes(std::span{data, size});
    const auto way = test::way_of(static_cast<std::uint32_t>(size));
    test::play(bytes, way);
    if (size >= test::sealed_from)
        test::play(test::sealed(bytes), way);
    return 0;
}
