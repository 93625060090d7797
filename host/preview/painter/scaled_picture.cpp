#include "host/preview/painter/scaled_picture.hpp"

#include <algorithm>
#include <cstdint>

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

ScaledPicture::ScaledPicture(const Picture& picture, Rect target)
    : picture_{picture},
      target_{target},
      columns_{shares(picture.size.width, target.width)},
      rows_{shares(picture.size.height, target.height)}
{
}

std::vector<ScaledPicture::Share> ScaledPicture::shares(int pixels, int target)
{
    std::vector<Share> shares;
    for (std::int64_t i = 0; i < target; ++i) {
        const int first = static_cast<int>(i * pixels / target);
        shares.push_back({first, std::max(first + 1, static_cast<int>((i + 1) * pixels / target))});
    }
    return shares;
}

Colour ScaledPicture::at(int x, int y) const
{
    const Share& columns = columns_[static_cast<std::size_t>(x - target_.x)];
    const Share& rows = rows_[static_cast<std::size_t>(y - target_.y)];
    const bool is_one = columns.end - columns.first == 1 && rows.end - rows.first == 1;
    return is_one ? picture_.at(columns.first, rows.first) : mean(columns, rows);
}

Colour ScaledPicture::mean(Share columns, Share rows) const
{
    std::int64_t red = 0;
    std::int64_t green = 0;
    std::int64_t blue = 0;
    for (int y = rows.first; y < rows.end; ++y)
        for (int x = columns.first; x < columns.end; ++x) {
            const Colour& pixel = picture_.at(x, y);
            red += pixel.red;
            green += pixel.green;
            blue += pixel.blue;
        }
    const std::int64_t count = std::int64_t{columns.end - columns.first} * (rows.end - rows.first);
    const auto share = [count](std::int64_t sum) {
        return static_cast<std::uint8_t>((sum + count / 2) / count);
    };
    return {share(red), share(green), share(blue)};
}

}
