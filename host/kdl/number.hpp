#pragma once

#include "host/kdl/document.hpp"

#include <string>
#include <string_view>
#include <variant>

namespace kfast::kdl {

/// What is wrong with a word that begins like a number.
struct NumberFault {
    std::string message;
    std::string hint;
};

/// Reads a decimal, hexadecimal, octal or binary number; the keywords such as #inf are not read here.
/// Hexadecimal, octal and binary numbers of more than 1000 digits are refused, for converting them to decimal
/// takes time that grows with the square of their length.
std::variant<Number, NumberFault> number_from(std::string_view word);

}
