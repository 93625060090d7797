#include "host/picture/palette.hpp"

#include "host/program/failure.hpp"

#include <algorithm>
#include <array>
#include <gif_lib.h>
#include <unordered_map>

namespace kfast {
namespace {

constexpr std::uint32_t word(Colour colour)
{
    return std::uint32_t{colour.red} << 16 | std::uint32_t{colour.green} << 8 | colour.blue;
}

constexpr Colour colour(std::uint32_t word)
{
    return {static_cast<std::uint8_t>(word >> 16), static_cast<std::uint8_t>(word >> 8),
            static_cast<std::uint8_t>(word)};
}

std::vector<std::uint8_t> channel(const Picture& picture, std::uint8_t Colour::*member)
{
    std::vector<std::uint8_t> values(picture.pixels.size());
    std::ranges::transform(picture.pixels, values.begin(), member);
    return values;
}

IndexedPicture quantized(const Picture& picture)
{
    std::vector<std::uint8_t> red = channel(picture, &Colour::red);
    std::vector<std::uint8_t> green = channel(picture, &Colour::green);
    std::vector<std::uint8_t> blue = channel(picture, &Colour::blue);
    std::array<GifColorType, Palette::max> map{};
    int count = Palette::max;
    IndexedPicture result{{}, std::vector<std::uint8_t>(picture.pixels.size())};
    if (GifQuantizeBuffer(static_cast<unsigned>(picture.size.width),
                          static_cast<unsigned>(picture.size.height), &count, red.data(), green.data(),
                          blue.data(), result.indices.data(), map.data()) != GIF_OK)
        throw Failure("cannot reduce a picture to 256 colours: not enough memory");
    for (const GifColorType& entry : map)
        result.colours.push_back({entry.Red, entry.Green, entry.Blue});
    return result;
}

}

bool Palette::add(const Picture& picture)
{
    std::optional<Colour> before; // most pixels are as the one before, and need no search
    for (const Colour pixel : picture.pixels) {
        if (pixel == before)
            continue;
        before = pixel;
        if (words_.insert(word(pixel)).second && words_.size() > max)
            return false;
    }
    return true;
}

std::vector<Colour> Palette::colours() const
{
    std::vector<Colour> list(words_.size());
    std::ranges::transform(words_, list.begin(), colour);
    return list;
}

std::vector<std::uint8_t> Palette::indices(const Picture& picture) const
{
    std::unordered_map<std::uint32_t, std::uint8_t> places;
    for (const std::uint32_t each : words_)
        places.emplace(each, static_cast<std::uint8_t>(places.size()));
    std::vector<std::uint8_t> result;
    result.reserve(picture.pixels.size());
    std::optional<Colour> before;
    for (const Colour pixel : picture.pixels) {
        result.push_back(pixel == before ? result.back() : places.at(word(pixel)));
        before = pixel;
    }
    return result;
}

IndexedPicture indexed(const Picture& picture)
{
    Palette palette;
    if (!palette.add(picture))
        return quantized(picture);
    return {palette.colours(), palette.indices(picture)};
}

}
