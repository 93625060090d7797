#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

namespace kfast::schema {

/// What people write in the place of what an expression has.
struct Slip {
    std::string_view written;
    std::string_view hint;
};

inline constexpr std::array slips{
    Slip{"\u2212", "the minus of the keyboard is -"},
    Slip{"\u2013", "the minus of the keyboard is -"},
    Slip{"\u00D7", "write * to multiply"},
    Slip{"\u00F7", "write / to divide"},
    Slip{",", "a number has a point: 1.5"},
    Slip{"+", "write a value in front of it, and what has blanks in it in quotes"},
    Slip{"*", "write a value in front of it, and what has blanks in it in quotes"},
    Slip{"/", "write a value in front of it, and what has blanks in it in quotes"},
};

/// The hint for what cannot stand in an expression, or not in its place.
inline std::string hint_of_misplaced(std::string_view written)
{
    const auto slip = std::ranges::find(slips, written, &Slip::written);
    return std::string{slip != slips.end() ? slip->hint
                                           : "operators are + - * /, functions min, max, round, sin, cos"};
}

}
