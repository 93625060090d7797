#include "host/beam/ilda_format.hpp"

#include <algorithm>
#include <array>

namespace kfast {

namespace {

constexpr Colour colour_of(std::uint32_t rgb)
{
    return {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8),
            static_cast<std::uint8_t>(rgb)};
}

constexpr std::array<std::uint32_t, 64> default_colours{
    0xFF0000, 0xFF1000, 0xFF2000, 0xFF3000, 0xFF4000, 0xFF5000, 0xFF6000, 0xFF7000, // from red to
    0xFF8000, 0xFF9000, 0xFFA000, 0xFFB000, 0xFFC000, 0xFFD000, 0xFFE000, 0xFFF000, //
    0xFFFF00, 0xE0FF00, 0xC0FF00, 0xA0FF00, 0x80FF00, 0x60FF00, 0x40FF00, 0x20FF00, // yellow
    0x00FF00, 0x00FF24, 0x00FF49, 0x00FF6D, 0x00FF92, 0x00FFB6, 0x00FFDB, 0x00FFFF, // green; cyan
    0x00E3FF, 0x00C6FF, 0x00AAFF, 0x008EFF, 0x0071FF, 0x0055FF, 0x0038FF, 0x001CFF, //
    0x0000FF, 0x2000FF, 0x4000FF, 0x6000FF, 0x8000FF, 0xA000FF, 0xC000FF, 0xE000FF, // blue
    0xFF00FF, 0xFF20FF, 0xFF40FF, 0xFF60FF, 0xFF80FF, 0xFFA0FF, 0xFFC0FF, 0xFFE0FF, // magenta
    0xFFFFFF, 0xFFE0E0, 0xFFC0C0, 0xFFA0A0, 0xFF8080, 0xFF6060, 0xFF4040, 0xFF2020, // white
};

constexpr auto palette = [] {
    std::array<Colour, default_colours.size()> colours{};
    std::ranges::transform(default_colours, colours.begin(), colour_of);
    return colours;
}();

int distance(Colour one, Colour other)
{
    const int red = one.red - other.red;
    const int green = one.green - other.green;
    const int blue = one.blue - other.blue;
    return red * red + green * green + blue * blue;
}

}

std::span<const Colour> default_ilda_palette() { return palette; }

IldaPalette::IldaPalette() : colours_{palette.begin(), palette.end()} {}

IldaPalette::IldaPalette(std::span<const std::vector<BeamPoint>> frames) : IldaPalette{}
{
    for (const std::vector<BeamPoint>& points : frames)
        add(points);
}

void IldaPalette::add(std::span<const BeamPoint> points)
{
    for (const BeamPoint& point : points) {
        if (!point.is_lit() || std::ranges::find(colours_, point.colour) != colours_.end())
            continue;
        if (colours_.size() < max_ilda_colours)
            colours_.push_back(point.colour);
        else
            is_too_small_ = true;
    }
}

std::uint8_t IldaPalette::index(Colour colour) const
{
    const auto nearest =
        std::ranges::min_element(colours_, {}, [colour](Colour known) { return distance(known, colour); });
    return static_cast<std::uint8_t>(nearest - colours_.begin());
}

}
