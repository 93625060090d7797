#pragma once

#include "host/kdl/scanner.hpp"

namespace kfast::kdl {

/// Reports what no document may hold: bytes that are not UTF-8, and disallowed code points.
///
/// Of the former only the first, and false: the text cannot be parsed. Goes over no text, except over a byte
/// order mark at the beginning.
bool check_encoding(Scanner& scanner);

}
