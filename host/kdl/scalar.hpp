#pragma once

#include "host/kdl/document.hpp"
#include "host/kdl/scanner.hpp"

namespace kfast::kdl {

/// Whether a string, a number or a keyword comes next, be it right or wrong.
bool at_scalar(const Scanner& scanner);

/// At a scalar: goes over it and sets the data and the text offset of `value`. Errors are reported, and false
/// returned.
bool read_scalar(Scanner& scanner, Value& value);

}
