#include "host/preview/painter/placement.hpp"

#include <algorithm>

namespace kfast {
namespace {

Size magnified(Size picture, int zoom) { return {picture.width * zoom, picture.height * zoom}; }

/// Rounds down, to at least one pixel.
Size shrunk(Size picture, Size space)
{
    if (picture.width * space.height > picture.height * space.width)
        return {space.width, std::max(1, picture.height * space.width / picture.width)};
    return {std::max(1, picture.width * space.height / picture.height), space.height};
}

}

Rect placement(Size picture, Size space)
{
    const int zoom = std::min(space.width / picture.width, space.height / picture.height);
    const Size shown = zoom > 0 ? magnified(picture, zoom) : shrunk(picture, space);
    return {(space.width - shown.width) / 2, (space.height - shown.height) / 2, shown.width, shown.height};
}

}
