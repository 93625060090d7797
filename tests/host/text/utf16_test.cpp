#include "host/text/characters.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

using namespace std::string_view_literals;

TEST_CASE("texts in UTF-16 are known by their mark, or by the zero beside their first character")
{
    CHECK(first_of_utf16("\xFF\xFEk\0"sv) == 'k');
    CHECK(first_of_utf16("\xFE\xFF\0k"sv) == 'k');
    CHECK(first_of_utf16("<\0s\0"sv) == '<');
    CHECK(first_of_utf16("\0\t"sv) == '\t');
    CHECK(seems_utf16("\xFF\xFE"sv));
    CHECK(seems_utf16("/\0/\0"sv));
}

TEST_CASE("other bytes are no text in UTF-16")
{
    for (const std::string_view bytes : {""sv, "k"sv, "kfast 1"sv, "\0"sv, "\0asm"sv.substr(0, 1), "\0\0"sv,
                                         "\0\x01"sv, "\xFF\0"sv, "\0\x80"sv, "\x7F\0"sv}) {
        CHECK(first_of_utf16(bytes) == '\0');
        CHECK_FALSE(seems_utf16(bytes));
    }
}

}
