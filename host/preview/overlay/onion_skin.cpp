#include "host/preview/overlay/onion_skin.hpp"

#include "core/pixel/pixel_row.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace kfast {
namespace {

constexpr int whole = 255;
constexpr int emphasis = 3;

int difference(Colour a, Colour b)
{
    return std::max({std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
}

std::uint8_t tinted(int channel, int tint, int weight)
{
    constexpr int square = whole * whole;
    const int shift = (tint - channel) * weight * OnionSkin::faintness;
    return static_cast<std::uint8_t>(channel + (shift + (shift < 0 ? -square : square) / 2) / square);
}

Colour tinted(Colour colour, Colour tint, int weight)
{
    return {tinted(colour.red, tint.red, weight), tinted(colour.green, tint.green, weight),
            tinted(colour.blue, tint.blue, weight), colour.opacity};
}

/// A panel like that of `frame` on which nothing is painted.
Picture unpainted(const Frame& frame, Colour background)
{
    Frame empty{frame.format, frame.size, std::vector<std::byte>(frame.pixels.size())};
    if (frame.format)
        with_format(*frame.format, [&]<PixelFormat format>() {
            using Row = PixelRow<format>;
            const std::size_t stride = row_bytes(format, frame.size.width);
            for (int y = 0; y < frame.size.height; ++y)
                Row{empty.pixels.data() + stride * static_cast<std::size_t>(y), 0, y}.fill(
                    0, frame.size.width, Row::ink(background));
        });
    return widen(empty);
}

std::optional<Time> key_before(std::span<const Time> keys, Time moment)
{
    const auto first = std::ranges::lower_bound(keys, moment);
    return first == keys.begin() ? std::nullopt : std::optional{*(first - 1)};
}

std::optional<Time> key_after(std::span<const Time> keys, Time moment)
{
    const auto first = std::ranges::upper_bound(keys, moment);
    return first == keys.end() ? std::nullopt : std::optional{*first};
}

}

void lay_skin(Picture& picture, const Picture& neighbour, const Picture& background, Colour tint)
{
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        Colour& pixel = picture.pixels[i];
        const Colour other = neighbour.pixels[i];
        const int far = std::min(difference(other, pixel), difference(other, background.pixels[i]));
        if (far != 0)
            pixel = tinted(pixel, tint, std::min(emphasis * far, whole));
    }
}

const Picture& OnionSkin::show(FrameSource& source, Time moment, std::span<const Time> keys)
{
    look_up(before_, key_before(keys, moment), source);
    look_up(after_, key_after(keys, moment), source);
    const Frame& frame = source.show(moment);
    picture_ = widen(frame);
    if (empty_.pixels.size() != picture_.pixels.size())
        empty_ = unpainted(frame, background_);
    if (before_.key)
        lay_skin(picture_, before_.picture, empty_, warm);
    if (after_.key)
        lay_skin(picture_, after_.picture, empty_, cool);
    return picture_;
}

void OnionSkin::forget()
{
    before_.key.reset();
    after_.key.reset();
}

void OnionSkin::look_up(Neighbour& neighbour, std::optional<Time> key, FrameSource& source)
{
    if (key && neighbour.key != key)
        neighbour.picture = widen(source.show(*key));
    neighbour.key = key;
}

}
