#pragma once

#include "host/kdl/document.hpp"

#include <span>
#include <string>
#include <string_view>

namespace kfast::kdl {

/// `nodes` as a person would write them: short nodes on one line, with their children in braces; others have
/// the children below. Neighbours of one name that is among `crowded` share lines. Texts with line ends are
/// put between lines of """; they must not hold anything that needs an escape. Locations are ignored.
std::string readable(std::span<const Node> nodes, std::span<const std::string_view> crowded);

}
