#pragma once

#include "host/kdl/document.hpp"

#include <span>
#include <string>
#include <string_view>

namespace kfast::kdl {

/// `nodes` as a person would write them: short nodes on one line, with their children in braces; of others
/// the children below. Neighbours of one name that is among `crowded` share lines. Texts with line ends stand
/// between lines of """; they must not hold anything that needs an escape. Places are not looked at.
std::string readable(std::span<const Node> nodes, std::span<const std::string_view> crowded);

}
