#pragma once

#include "core/pixel/paint_style.hpp"
#include "host/picture/svg_number.hpp"

#include <cstdio>
#include <string>

namespace kfast {

/// "#ff8000"; its opacity is left out.
inline std::string svg_colour(Colour colour)
{
    char text[16];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", colour.red, colour.green, colour.blue);
    return text;
}

/// ` fill="#ff8000" fill-opacity="0.5"` for a property "fill" and a colour under an opacity of 0 … 255.
inline std::string paint_text(const std::string& property, Colour colour, std::uint32_t opacity)
{
    const std::uint32_t share = product_of_opacities(colour.opacity, opacity);
    const std::string paint = ' ' + property + "=\"" + svg_colour(colour) + '"';
    return share == 255 ? paint : paint + ' ' + property + "-opacity=\"" + svg_share(share) + '"';
}

}
