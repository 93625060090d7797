#include "host/kdl/code_point_class.hpp"

#include <string_view>

namespace kfast::kdl {

namespace {

constexpr std::u32string_view spaces = U"\t \u00A0\u1680\u202F\u205F\u3000";
constexpr std::u32string_view newlines = U"\n\v\f\r\u0085\u2028\u2029";
constexpr std::u32string_view punctuation = U"\\/(){};[]\"#=";

bool is_within(char32_t point, char32_t first, char32_t last) { return first <= point && point <= last; }

bool is_control(char32_t point) { return point <= 0x08 || is_within(point, 0x0E, 0x1F) || point == 0x7F; }

bool is_direction_mark(char32_t point)
{
    return is_within(point, 0x200E, 0x200F) || is_within(point, 0x202A, 0x202E) ||
           is_within(point, 0x2066, 0x2069);
}

}

bool is_space(char32_t point)
{
    return spaces.find(point) != spaces.npos || is_within(point, 0x2000, 0x200A);
}

bool is_newline(char32_t point) { return newlines.find(point) != newlines.npos; }

bool is_disallowed(char32_t point)
{
    return is_control(point) || is_direction_mark(point) || is_within(point, 0xD800, 0xDFFF) ||
           point == 0xFEFF;
}

bool is_identifier_character(char32_t point)
{
    return point <= 0x10FFFF && punctuation.find(point) == punctuation.npos && !is_space(point) &&
           !is_newline(point);
}

}
