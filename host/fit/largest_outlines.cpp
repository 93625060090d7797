#include "host/fit/largest_outlines.hpp"

#include "host/walk/outline_items.hpp"

namespace kfast::fit {

LargestOutlines outlines_of(Time moment, const raster::Picture& picture)
{
    LargestOutlines outlines{.moment = moment, .bytes = picture.outlines.needed_bytes()};
    for (const auto& [path, bytes] : outline_bytes_by_item(picture))
        if (bytes > outlines.item_bytes) {
            outlines.path = path;
            outlines.item_bytes = bytes;
        }
    return outlines;
}

}
