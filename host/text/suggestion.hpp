#pragma once

#include <span>
#include <string>
#include <string_view>

namespace kfast {

/// `did you mean "circle"?`, the first of those of `known` that are closest to `name`; empty when none is
/// close.
std::string did_you_mean(std::string_view name, std::span<const std::string_view> known);

/// The hint for a name that is not among `known`: did_you_mean() when one of them is close, else the list
/// of what is allowed, cut when it is long.
std::string suggestion(std::string_view name, std::span<const std::string_view> known);

}
