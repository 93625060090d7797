#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace kfast::svg {

/// The longest name that is kept, in bytes: files repeat them wherever something is used.
inline constexpr std::size_t longest_name = 255;

/// A text as it is, or its beginning of at most `max` bytes with "..." behind it; never half of a character.
std::string shortened(std::string_view text, std::size_t max = 40);

}
