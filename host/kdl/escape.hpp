#pragma once

#include "host/kdl/scanner.hpp"

#include <string>
#include <string_view>

namespace kfast::kdl {

/// At the \ of an escape in a quoted string: goes over it and appends what it represents, which is nothing
/// for escaped white space. An error is reported and false returned; the string can be read on after it.
bool read_escape(Scanner& scanner, std::string& text);

/// `text` as the inside of a quoted string of canonical form.
std::string escaped(std::string_view text);

}
