#include "host/preview/painter/raster_painter.hpp"

#include "core/bytes/code_point.hpp"
#include "host/preview/painter/area.hpp"
#include "host/preview/painter/scaled_picture.hpp"

#include <algorithm>

namespace kfast {
namespace {

std::uint8_t mixed(int below, int above, int share)
{
    return static_cast<std::uint8_t>((below * (255 - share) + above * share + 127) / 255);
}

/// `share` of 255 of it is seen.
Colour mixed(Colour below, Colour above, int share)
{
    return {mixed(below.red, above.red, share), mixed(below.green, above.green, share),
            mixed(below.blue, above.blue, share)};
}

}

void RasterPainter::begin(Size size)
{
    canvas_.size = size;
    canvas_.pixels.assign(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height), {});
    clip(std::nullopt);
}

void RasterPainter::clip(std::optional<Rect> area)
{
    const Rect all{0, 0, canvas_.size.width, canvas_.size.height};
    clip_ = area ? common(*area, all) : all;
}

Colour* RasterPainter::row(int y) { return canvas_.pixels.data() + std::ptrdiff_t{y} * canvas_.size.width; }

void RasterPainter::cover(int x, int y, int width, std::uint8_t share, Colour colour)
{
    const Rect seen = common({x, y, width, 1}, clip_);
    if (is_empty(seen))
        return;
    const int all = (share * colour.opacity + 127) / 255;
    colour.opacity = 255;
    Colour* const first = row(y) + seen.x;
    if (all == 255)
        std::fill_n(first, seen.width, colour);
    else
        std::transform(first, first + seen.width, first,
                       [&](Colour below) { return mixed(below, colour, all); });
}

void RasterPainter::fill(Rect area, Colour colour)
{
    const Rect seen = common(area, clip_);
    for (int y = seen.y; y < bottom_of(seen); ++y)
        cover(seen.x, y, seen.width, 255, colour);
}

void RasterPainter::polygon(std::span<const WindowSpot> corners, Colour colour)
{
    raster_.trace(corners, clip_, [this, colour](int x, int y, int width, std::uint8_t share) {
        cover(x, y, width, share, colour);
    });
}

/// Within its cell: what goes beyond, at most an edge, would touch its neighbour.
void RasterPainter::letter(int x, int y, const LetterMask& mask, Colour colour)
{
    auto share = mask.cover.begin();
    for (int down = 0; down < mask.place.height; ++down)
        for (int right = 0; right < mask.place.width; ++right, ++share)
            if (contains({0, 0, Painter::letter.width, Painter::letter.height}, mask.place.x + right,
                         mask.place.y + down))
                cover(x + mask.place.x + right, y + mask.place.y + down, 1, *share, colour);
}

void RasterPainter::text(int x, int y, std::string_view text, Colour colour)
{
    for (std::size_t at = 0; at < text.size();) {
        const CodePoint point = code_point_at(text, at);
        letter(x, y, font_.letter(point.value), colour);
        x += Painter::letter.width;
        at += point.length;
    }
}

void RasterPainter::picture(const Picture& picture, Rect target)
{
    const ScaledPicture scaled{picture, target};
    const Rect seen = common(target, clip_);
    for (int y = seen.y; y < bottom_of(seen); ++y)
        for (int x = seen.x; x < right_of(seen); ++x)
            row(y)[x] = scaled.at(x, y);
}

}
