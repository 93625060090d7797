#include "host/words/property_value.hpp"

#include <array>
#include <cstdio>

namespace kfast {

double written_amount(Property property, double stored)
{
    switch (property) {
    case Property::rotation_x:
    case Property::rotation_y:
    case Property::rotation:
        return stored * 360.0 / 65536;
    case Property::scale_x:
    case Property::scale_y:
        return stored / scale_one;
    case Property::along:
        return stored / path_whole;
    case Property::opacity:
        return stored / 255.0;
    case Property::order:
    case Property::visible:
        return stored;
    default:
        return stored / 16.0;
    }
}

std::string colour_text(Colour colour)
{
    std::array<char, 10> text{};
    std::snprintf(text.data(), text.size(), colour.opacity == 255 ? "#%02x%02x%02x" : "#%02x%02x%02x%02x",
                  static_cast<unsigned>(colour.red), static_cast<unsigned>(colour.green),
                  static_cast<unsigned>(colour.blue), static_cast<unsigned>(colour.opacity));
    return text.data();
}

}
