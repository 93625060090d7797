#include "host/flash/uf2.hpp"
#include "host/flash/uf2_contents.hpp"
#include "tests/demand.hpp"

#include <cstdint>
#include <stdexcept>
#include <string_view>

using namespace kfast;

namespace {

/// Regions in order, apart from each other, and no more bytes than the blocks have room for.
void demand_sense(const Uf2Contents& contents, std::size_t file_bytes)
{
    demand(contents.blocks == file_bytes / 512);
    for (const Uf2Mistake& mistake : contents.mistakes)
        demand(mistake.block <= contents.blocks && !mistake.reason.empty());
    std::size_t bytes = 0;
    for (const Uf2Part& part : contents.parts) {
        std::uint64_t end = 0;
        for (const FlashRegion& region : part.regions) {
            demand(!region.bytes.empty() && (end == 0 || region.address > end));
            end = std::uint64_t{region.address} + region.bytes.size();
            bytes += region.bytes.size();
        }
        demand(end <= std::uint64_t{1} << 32);
    }
    demand(bytes <= file_bytes);
    demand(!contents.mistakes.empty() || !contents.parts.empty());
}

}

/// Any bytes at all: what is wrong with them is told, or they hold regions. Those of the RP2040 come back,
/// padded to whole sectors, from a file of our own if no two share a sector.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
try {
    const auto file = std::as_bytes(std::span{data, size});
    demand_sense(read_uf2(file), size);
    const auto regions = regions_of(file);
    demand(!regions.empty());
    const auto again = regions_of(uf2_of(regions));
    demand(regions_of(uf2_of(again)) == again);
    return 0;
} catch (const std::invalid_argument& reason) {
    demand(!std::string_view{reason.what()}.empty());
    return 0;
}
