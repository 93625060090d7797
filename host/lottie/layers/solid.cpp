#include "host/geometry/shape.hpp"
#include "host/lottie/layers/layer.hpp"

#include <charconv>

namespace kfast::lottie {

namespace {

/// #rgb as #rrggbb, and without an opacity, which solids have not.
std::string six_digits(const std::string& text)
{
    if (text.size() == 4)
        return {text[0], text[1], text[1], text[2], text[2], text[3], text[3]};
    return text.size() == 9 ? text.substr(0, 7) : text;
}

}

art::Drawing solid_drawing(const Json& solid)
{
    const double width = number_at(solid, "sw");
    const double height = number_at(solid, "sh");
    if (!(width > 0 && height > 0))
        return {};
    return {{scene::rectangle({0, 0}, width, height, 0)}};
}

std::optional<art::Rgb> solid_colour(const Json& solid)
{
    const std::string text = six_digits(text_at(solid, "sc"));
    unsigned value = 0;
    const char* const end = text.data() + text.size();
    if (text.size() != 7 || text[0] != '#' || std::from_chars(text.data() + 1, end, value, 16).ptr != end)
        return std::nullopt;
    const auto channel = [&](unsigned shift) { return (value >> shift & 0xff) / 255.0; };
    return art::Rgb{channel(16), channel(8), channel(0)};
}

}
