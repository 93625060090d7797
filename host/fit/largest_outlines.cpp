#include "host/fit/largest_outlines.hpp"

#include <map>

namespace kfast::fit {
namespace {

std::size_t bytes_of(const OutlineRange& outlines)
{
    return static_cast<std::size_t>(outlines.end_corner - outlines.first_corner) * sizeof(Corner) +
           static_cast<std::size_t>(outlines.end_chain - outlines.first_chain) * sizeof(Chain);
}

/// What the outlines of each item take.
std::map<std::uint32_t, std::size_t> outline_bytes(const TracedPicture& picture)
{
    std::map<std::uint32_t, std::size_t> bytes;
    for (const PaintStep& step : picture.steps())
        bytes[step.item] += bytes_of(step.layer.outlines);
    return bytes;
}

}

LargestOutlines outlines_of(Time moment, const TracedPicture& picture)
{
    LargestOutlines outlines{.moment = moment, .bytes = picture.outlines.used_bytes()};
    for (const auto& [path, bytes] : outline_bytes(picture))
        if (bytes > outlines.item_bytes) {
            outlines.path = path;
            outlines.item_bytes = bytes;
        }
    return outlines;
}

}
