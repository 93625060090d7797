#pragma once

#include "host/art/document/document.hpp"

#include <optional>
#include <string_view>

namespace kfast::svg {

/// What is painted with.
struct Ink {
    art::Rgb colour;
    double opacity = 1; ///< 0 to 1
    friend bool operator==(const Ink&, const Ink&) = default;
};

/// A colour as CSS writes it: a name, "#rgb", "#rgba", "#rrggbb", "#rrggbbaa", rgb(), rgba(), hsl(), hsla(),
/// or "transparent". Names and words in any case. Nothing if it is none of these.
std::optional<Ink> colour(std::string_view text);

}
