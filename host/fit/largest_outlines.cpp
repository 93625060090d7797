#include "host/fit/largest_outlines.hpp"

#include <map>

namespace kfast::fit {
namespace {

/// What the outlines of each item take.
std::map<std::uint32_t, std::size_t> outline_bytes(const raster::Picture& picture)
{
    std::map<std::uint32_t, std::size_t> bytes;
    picture.outlines.each_chain([&](const raster::Chain& chain) {
        bytes[picture.steps()[chain.layer].item] += raster::OutlineStore::chain_bytes(chain);
    });
    return bytes;
}

}

LargestOutlines outlines_of(Time moment, const raster::Picture& picture)
{
    LargestOutlines outlines{.moment = moment, .bytes = picture.outlines.needed_bytes()};
    for (const auto& [path, bytes] : outline_bytes(picture))
        if (bytes > outlines.item_bytes) {
            outlines.path = path;
            outlines.item_bytes = bytes;
        }
    return outlines;
}

}
