#include "host/picture/picture.hpp"

#include "core/bytes/crc32.hpp"
#include "core/pixel/pixel_row.hpp"
#include "host/program/failure.hpp"

#include <algorithm>
#include <span>
#include <string>

namespace kfast {

std::uint32_t hash(const Frame& frame)
{
    Crc32 crc;
    crc.add(frame.pixels);
    return crc.value();
}

namespace {

constexpr std::uint8_t widened(std::uint32_t value, std::uint32_t max)
{
    return static_cast<std::uint8_t>(widen_channel(value, max));
}

/// For channels of that many bits, red in the highest.
constexpr Colour rgb(std::uint32_t pixel, int red, int green, int blue)
{
    const auto channel = [pixel](int shift, int bits) {
        const std::uint32_t max = (1U << bits) - 1;
        return widened(pixel >> shift & max, max);
    };
    return {channel(green + blue, red), channel(blue, green), channel(0, blue)};
}

constexpr Colour grey(std::uint32_t value, std::uint32_t max)
{
    const std::uint8_t level = widened(value, max);
    return {level, level, level};
}

Colour pixel(PixelFormat format, const std::byte* row, int x)
{
    const auto byte = [row](int index) { return std::to_integer<std::uint32_t>(row[index]); };
    switch (format) {
    case PixelFormat::rgb565:
        return rgb(byte(2 * x) | byte(2 * x + 1) << 8, 5, 6, 5);
    case PixelFormat::rgb565_be:
        return rgb(byte(2 * x) << 8 | byte(2 * x + 1), 5, 6, 5);
    case PixelFormat::rgb444: {
        const std::uint32_t two_bytes = byte(3 * x / 2) << 8 | byte(3 * x / 2 + 1);
        return rgb(x % 2 == 0 ? two_bytes >> 4 : two_bytes, 4, 4, 4);
    }
    case PixelFormat::rgb666:
        return {widened(byte(3 * x) >> 2, 63), widened(byte(3 * x + 1) >> 2, 63),
                widened(byte(3 * x + 2) >> 2, 63)};
    case PixelFormat::grey4:
        return grey((byte(x / 2) >> (x % 2 == 0 ? 4 : 0)) & 15, 15);
    case PixelFormat::mono1:
    case PixelFormat::mono1_dithered:
        return grey((byte(x / 8) >> (7 - x % 8)) & 1, 1);
    }
    return {};
}

Picture without_format(const Frame& frame)
{
    Picture picture{frame.size, {}};
    picture.pixels.reserve(frame.pixels.size() / 3);
    for (std::size_t i = 0; i + 2 < frame.pixels.size(); i += 3)
        picture.pixels.push_back({std::to_integer<std::uint8_t>(frame.pixels[i]),
                                  std::to_integer<std::uint8_t>(frame.pixels[i + 1]),
                                  std::to_integer<std::uint8_t>(frame.pixels[i + 2])});
    return picture;
}

Picture in_format(const Frame& frame, PixelFormat format)
{
    Picture picture{frame.size, {}};
    picture.pixels.reserve(static_cast<std::size_t>(frame.size.width) *
                           static_cast<std::size_t>(frame.size.height));
    const std::size_t stride = row_bytes(format, frame.size.width);
    for (int y = 0; y < frame.size.height; ++y) {
        const std::byte* row = frame.pixels.data() + stride * static_cast<std::size_t>(y);
        for (int x = 0; x < frame.size.width; ++x)
            picture.pixels.push_back(pixel(format, row, x));
    }
    return picture;
}

}

Picture widen(const Frame& frame)
{
    return frame.format ? in_format(frame, *frame.format) : without_format(frame);
}

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

/// The columns that differ in one of the rows: from the first to the one after the last.
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
