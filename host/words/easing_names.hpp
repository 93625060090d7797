#pragma once

#include <span>
#include <string_view>

namespace kfast {

/// What CSS, or the easing functions of Robert Penner, call a curve of which the scene language has the like.
struct EasingName {
    std::string_view name; ///< in small letters, parts joined by "-": "ease-in-out-quad"
    std::string_view law;  ///< in the scene language: a keyword, or a bezier with its numbers
};

/// Laws that are beziers are the nearest ones; docs/scene-language.md tells how near.
std::span<const EasingName> easing_names();

/// The law of a name that is written in one of the usual ways, "easeInOutQuad", "ease_in_out_quad" or
/// "ease-in-out-quad": a keyword of the language itself too. Empty if it is none.
std::string_view law_of_easing(std::string_view word);

}
