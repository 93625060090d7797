#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace kfast::schema {

constexpr bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

/// A letter of ASCII, or _.
constexpr bool begins_name(char letter)
{
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || letter == '_';
}

/// Where the letters, digits and _ end that stand in `text` from `begin` on.
std::size_t name_end(std::string_view text, std::size_t begin);

/// The names of variables in an expression, each as often as it stands there, whether there are such
/// variables or not.
std::vector<std::string_view> names_in(std::string_view text);

/// Of variables and functions: what the text begins with; empty if that is no name.
std::string_view name_in_front(std::string_view text);

/// Letters, digits and _, not beginning with a digit, and no function.
bool is_variable_name(std::string_view name);

}
