#include "host/picture/detail.hpp"

#include <algorithm>

namespace kfast {

Detail detail_of(const raster::Picture& picture)
{
    if (picture.outlines.is_full())
        return Detail::parts_missing;
    return picture.coarseness != 0 ? Detail::coarse : Detail::full;
}

void ShownDetail::add(const raster::Picture& picture)
{
    last_ = detail_of(picture);
    min_ = std::min(min_, last_);
}

std::string ShownDetail::text() const
{
    switch (last_) {
    case Detail::parts_missing:
        return "parts are missing, for want of room";
    case Detail::coarse:
        return "curves are coarser, for want of room";
    case Detail::full:
        break;
    }
    return {};
}

}
