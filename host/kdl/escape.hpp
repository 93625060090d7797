#pragma once

#include "host/kdl/scanner.hpp"

#include <string>
#include <string_view>

namespace kfast::kdl {

/// At the \ of an escape in a quoted string: goes over it and appends what it represents, which is nothing
/// for escaped white space. An error is reported and false returned; the string can be read on after it.
bool read_escape(Scanner& scanner, std::string& text);

/// How characters are written that KDL allows and that are not printable (is_printable()).
enum class Unseen { as_they_are, as_codes };

/// `text` as the inside of a quoted string; that of canonical form has unseen characters as they are.
std::string escaped(std::string_view text, Unseen unseen);

}
