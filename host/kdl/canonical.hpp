#pragma once

#include "host/kdl/document.hpp"

#include <string>
#include <string_view>

namespace kfast::kdl {

/// The canonical form that KDL's published test cases expect (tests/README.md of kdl-org/kdl).
std::string canonical(const Document& document);

/// `text` as a name or a value is written for people: bare where that is allowed, else in quotes, with what
/// is not printable as \u{…}.
std::string string_form(std::string_view text);

}
