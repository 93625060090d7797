#include "host/lottie/layer.hpp"
#include "host/scene/shape.hpp"

#include <charconv>

namespace kfast::lottie {

art::Drawing solid_drawing(const Json& solid)
{
    const double width = number_at(solid, "sw");
    const double height = number_at(solid, "sh");
    if (!(width > 0 && height > 0))
        return {};
    return {{scene::rectangle({0, 0}, width, height, 0)}};
}

art::Rgb solid_colour(const Json& solid)
{
    const std::string text = text_at(solid, "sc");
    unsigned value = 0;
    const char* const end = text.data() + text.size();
    if (text.size() != 7 || text[0] != '#' || std::from_chars(text.data() + 1, end, value, 16).ptr != end)
        throw WrongMember(solid, "\"sc\" is no colour: one is a text such as \"#ff8000\"");
    const auto channel = [&](unsigned shift) { return (value >> shift & 0xff) / 255.0; };
    return {channel(16), channel(8), channel(0)};
}

}
