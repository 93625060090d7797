#include "host/flash/uf2.hpp"

#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

using namespace kfast;

namespace {

void demand(bool condition)
{
    if (!condition)
        std::abort();
}

}

/// Any bytes at all: they are refused with a reason, or hold regions that come back, padded to whole sectors,
/// from a file of our own if no two share a sector.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
try {
    const auto regions = regions_of(std::as_bytes(std::span{data, size}));
    demand(!regions.empty());
    const auto again = regions_of(uf2_of(regions));
    demand(regions_of(uf2_of(again)) == again);
    return 0;
} catch (const std::invalid_argument& reason) {
    demand(!std::string_view{reason.what()}.empty());
    return 0;
}
