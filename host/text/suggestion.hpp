#pragma once

#include <span>
#include <string>
#include <string_view>

namespace kfast {

/// The remedy for a name that is not among `known`: `did you mean "circle"?` when one of them is close (the
/// first of the closest), else the list of what is allowed, cut when it is long.
std::string suggestion(std::string_view name, std::span<const std::string_view> known);

}
