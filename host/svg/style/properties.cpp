#include "host/svg/style/properties.hpp"

#include <algorithm>
#include <array>

namespace kfast::svg {
namespace {

constexpr auto read = Care::read;
constexpr auto silent = Care::silent;
constexpr auto reported = Care::reported;

constexpr std::array properties = std::to_array<Property>({
    {"clip-path", read},
    {"clip-rule", silent, true},
    {"color", read, true},
    {"cx", read},
    {"cy", read},
    {"d", read},
    {"display", read},
    {"fill", read, true},
    {"fill-opacity", read, true},
    {"fill-rule", read, true},
    {"font-size", read, true},
    {"height", read},
    {"marker", read},
    {"marker-end", read, true},
    {"marker-mid", read, true},
    {"marker-start", read, true},
    {"mask", read},
    {"opacity", read},
    {"overflow", read},
    {"paint-order", read, true},
    {"r", read},
    {"rx", read},
    {"ry", read},
    {"stop-color", read},
    {"stop-opacity", read},
    {"stroke", read, true},
    {"stroke-dasharray", read, true},
    {"stroke-dashoffset", read, true},
    {"stroke-linecap", read, true},
    {"stroke-linejoin", read, true},
    {"stroke-miterlimit", read, true},
    {"stroke-opacity", read, true},
    {"stroke-width", read, true},
    {"transform", read},
    {"transform-box", read},
    {"transform-origin", read},
    {"vector-effect", read},
    {"visibility", read, true},
    {"width", read},
    {"x", read},
    {"y", read},

    {"animation", reported, false, "none", "it does not move"},
    {"animation-name", reported, false, "none", "it does not move"},
    {"backdrop-filter", reported, false, "none", "nothing is filtered"},
    {"filter", reported, false, "none", "drawn without it"},
    {"mix-blend-mode", reported, false, "normal", "drawn over what lies below"},
    {"offset-path", reported, false, "none", "it stays in its place"},
    {"perspective", reported, false, "none", "seen flat"},
    {"rotate", reported, false, "none", "not turned; write it as a transform"},
    {"scale", reported, false, "none", "not scaled; write it as a transform"},
    {"translate", reported, false, "none", "not moved; write it as a transform"},
});

/// Of texts, of how fast or well something is drawn, of pointers and of pages.
constexpr std::array<std::string_view, 30> silent_beginnings{
    "-",        "alignment-", "animation-", "background", "baseline-",  "block-",    "border", "box-",
    "color-",   "cursor",     "direction",  "dominant-",  "enable-",    "flood-",    "font",   "glyph-",
    "image-",   "inline-",    "isolation",  "kerning",    "letter-",    "lighting-", "line-",  "mask-type",
    "pointer-", "shape-",     "solid-",     "text",       "transition", "word-"};
constexpr std::array<std::string_view, 17> silent_names{
    "all",         "content",     "margin",       "max-width", "min-width",      "outline",
    "padding",     "position",    "speak",        "tab-size",  "user-select",    "unicode-bidi",
    "white-space", "will-change", "writing-mode", "z-index",   "shape-rendering"};

constexpr std::array<std::string_view, 32> attributes{"class",
                                                      "dx",
                                                      "dy",
                                                      "externalResourcesRequired",
                                                      "gradientTransform",
                                                      "gradientUnits",
                                                      "href",
                                                      "id",
                                                      "lang",
                                                      "name",
                                                      "nonce",
                                                      "offset",
                                                      "pathLength",
                                                      "points",
                                                      "preserveAspectRatio",
                                                      "requiredExtensions",
                                                      "requiredFeatures",
                                                      "role",
                                                      "spreadMethod",
                                                      "style",
                                                      "systemLanguage",
                                                      "tabindex",
                                                      "target",
                                                      "type",
                                                      "version",
                                                      "viewBox",
                                                      "x1",
                                                      "x2",
                                                      "y1",
                                                      "y2",
                                                      "zoomAndPan",
                                                      "baseProfile"};

bool is_silent(std::string_view name)
{
    return std::ranges::any_of(silent_beginnings,
                               [&](auto beginning) { return name.starts_with(beginning); }) ||
           std::ranges::find(silent_names, name) != silent_names.end();
}

}

Property property_of(std::string_view name)
{
    const auto found = std::ranges::find(properties, name, &Property::name);
    if (found != properties.end())
        return *found;
    return {name, is_silent(name) ? silent : Care::unknown};
}

bool is_known_attribute(std::string_view name)
{
    return name.find(':') != name.npos || name.starts_with("xmlns") || name.starts_with("data-") ||
           name.starts_with("aria-") || std::ranges::find(attributes, name) != attributes.end() ||
           property_of(name).care != Care::unknown;
}

}
