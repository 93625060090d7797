#include "host/synfig/blending.hpp"

#include <map>
#include <string>

namespace kfast::synfig {
namespace {

// As files number them.
constexpr int composite = 0;
constexpr int behind = 12;

const std::map<int, const char*>& names()
{
    static const std::map<int, const char*> all{{1, "straight"},
                                                {2, "brighten"},
                                                {3, "darken"},
                                                {4, "add"},
                                                {5, "subtract"},
                                                {6, "multiply"},
                                                {7, "divide"},
                                                {8, "colour"},
                                                {9, "hue"},
                                                {10, "saturation"},
                                                {11, "luminance"},
                                                {13, "onto"},
                                                {14, "alpha brighten"},
                                                {15, "alpha darken"},
                                                {16, "screen"},
                                                {17, "hard light"},
                                                {18, "difference"},
                                                {19, "alpha over"},
                                                {20, "overlay"},
                                                {21, "straight onto"},
                                                {22, "add composite"},
                                                {23, "alpha intersection"}};
    return all;
}

/// Such layers take away from what lies below, and show nothing of their own.
bool erases(int method) { return method == 14 || method == 15 || method == 19 || method == 23; }

}

Blending blending_of(const Layer& layer, bool covers_all)
{
    const int method = layer.whole("blend_method", 0, composite);
    if (method == composite)
        return Blending::normal;
    if (method == behind)
        return Blending::behind;
    const auto name = names().find(method);
    const std::string feature =
        "blend method " +
        (name == names().end() ? std::to_string(method) : '"' + std::string{name->second} + '"');
    const bool left_out = erases(method) || covers_all;
    layer.lose(feature, left_out ? "the layer is left out" : "painted over what lies below");
    return left_out ? Blending::left_out : Blending::normal;
}

}
