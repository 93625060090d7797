#include "host/picture/picture_part.hpp"

#include "host/program/failure.hpp"

#include <algorithm>
#include <span>
#include <string>

namespace kfast {
namespace {

std::size_t place(const Picture& picture, int x, int y)
{
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.size.width) +
           static_cast<std::size_t>(x);
}

std::span<const Colour> row(const Picture& picture, int y)
{
    return std::span{picture.pixels}.subspan(place(picture, 0, y),
                                             static_cast<std::size_t>(picture.size.width));
}

/// The columns that differ in one of the rows: from the first to the one behind the last.
void widen_by_row(Rect& area, std::span<const Colour> before, std::span<const Colour> after)
{
    const auto [first, ignored] = std::ranges::mismatch(before, after);
    if (first == before.end())
        return;
    const auto last = std::mismatch(before.rbegin(), before.rend(), after.rbegin()).first;
    const int left = static_cast<int>(first - before.begin());
    const int right = static_cast<int>(before.rend() - last);
    const int end = std::max(area.x + area.width, right);
    area.x = std::min(area.x, left);
    area.width = end - area.x;
}

}

std::optional<Rect> changed_part(const Picture& before, const Picture& after)
{
    const auto differs = [&](int y) { return !std::ranges::equal(row(before, y), row(after, y)); };
    int top = 0;
    while (top < after.size.height && !differs(top))
        ++top;
    if (top == after.size.height)
        return std::nullopt;
    int bottom = after.size.height;
    while (!differs(bottom - 1))
        --bottom;
    Rect area{after.size.width, top, -after.size.width, bottom - top}; // no column yet
    for (int y = top; y < bottom; ++y)
        widen_by_row(area, row(before, y), row(after, y));
    return area;
}

Picture part(const Picture& picture, const Rect& area)
{
    Picture result{{area.width, area.height}, {}};
    for (int y = area.y; y < area.y + area.height; ++y) {
        const auto cut =
            row(picture, y).subspan(static_cast<std::size_t>(area.x), static_cast<std::size_t>(area.width));
        result.pixels.insert(result.pixels.end(), cut.begin(), cut.end());
    }
    return result;
}

Picture plain_picture(std::int64_t width, std::int64_t height, Colour colour, const char* what)
{
    if (std::max(width, height) > longest_picture_side || width * height > max_picture_pixels)
        throw Failure(std::string{what} + " would be " + std::to_string(width) + " x " +
                      std::to_string(height) + " pixels: at most " + std::to_string(longest_picture_side) +
                      " a side and " + std::to_string(max_picture_pixels) +
                      " in all are possible: choose a smaller --scale or --size, or less with --clip");
    return {{static_cast<int>(width), static_cast<int>(height)},
            std::vector<Colour>(static_cast<std::size_t>(width * height), colour)};
}

void put(const Picture& picture, Picture& sheet, int x, int y)
{
    for (int line = 0; line < picture.size.height; ++line)
        std::ranges::copy(row(picture, line),
                          sheet.pixels.begin() + static_cast<std::ptrdiff_t>(place(sheet, x, y + line)));
}

Picture scaled(const Picture& picture, int factor)
{
    Picture result = plain_picture(std::int64_t{picture.size.width} * factor,
                                   std::int64_t{picture.size.height} * factor, {}, "the picture");
    auto pixel = result.pixels.begin();
    for (int y = 0; y < result.size.height; ++y)
        for (const Colour colour : row(picture, y / factor))
            pixel = std::fill_n(pixel, factor, colour);
    return result;
}

}
