#include "host/text/characters.hpp"

#include <doctest/doctest.h>

using namespace kfast;

namespace {

std::string utf8(char32_t value)
{
    std::string text;
    append_utf8(text, value);
    return text;
}

bool is_lone_byte(std::string_view text)
{
    const CodePoint point = code_point_at(text, 0);
    return !point.valid && point.length == 1 && point.value == static_cast<unsigned char>(text[0]);
}

}

TEST_CASE("a code point is read back from what was written, at the borders of every length")
{
    for (const char32_t value :
         {0x0U, 0x7FU, 0x80U, 0x7FFU, 0x800U, 0xD7FFU, 0xE000U, 0xFFFFU, 0x10000U, 0x10FFFFU}) {
        const std::string text = utf8(value);
        const CodePoint point = code_point_at(text, 0);
        CHECK(point.valid);
        CHECK(point.value == value);
        CHECK(point.length == text.size());
    }
}

TEST_CASE("UTF-8 has the bytes that the standard says")
{
    CHECK(utf8(U'ß') == "\xC3\x9F");
    CHECK(utf8(U'€') == "\xE2\x82\xAC");
    CHECK(utf8(0x1F600) == "\xF0\x9F\x98\x80");
}

TEST_CASE("what is not UTF-8 is taken byte by byte")
{
    CHECK(is_lone_byte("\x80"));             // continues nothing
    CHECK(is_lone_byte("\xC3"));             // the text ends
    CHECK(is_lone_byte("\xC3x"));            // no continuation
    CHECK(is_lone_byte("\xC0\x80"));         // overlong
    CHECK(is_lone_byte("\xE0\x9F\xBF"));     // overlong
    CHECK(is_lone_byte("\xF0\x8F\xBF\xBF")); // overlong
    CHECK(is_lone_byte("\xED\xA0\x80"));     // a surrogate
    CHECK(is_lone_byte("\xF4\x90\x80\x80")); // above U+10FFFF
    CHECK(is_lone_byte("\xF8\x88\x80\x80\x80"));
    CHECK(is_lone_byte("\xFF"));
}

TEST_CASE("surrogates and what lies above U+10FFFF are no scalar values")
{
    CHECK(is_scalar_value(0xD7FF));
    CHECK_FALSE(is_scalar_value(0xD800));
    CHECK_FALSE(is_scalar_value(0xDFFF));
    CHECK(is_scalar_value(0xE000));
    CHECK(is_scalar_value(0x10FFFF));
    CHECK_FALSE(is_scalar_value(0x110000));
}
