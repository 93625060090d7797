#pragma once

#include "host/kdl/document.hpp"

#include <string>

namespace kfast::kdl {

/// The canonical form that KDL's published test cases expect (tests/README.md of kdl-org/kdl).
std::string canonical(const Document& document);

}
