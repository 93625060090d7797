#include "tests/host/kdl/reading.hpp"

#include "host/kdl/parser.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using kfast::test::errors;
using kfast::test::hint;
using kfast::test::reading;

namespace {

/// The text of the first argument of the first node.
std::string text_of(std::string_view document)
{
    Diagnostics diagnostics;
    const kdl::Document parsed = kdl::parse(document, diagnostics);
    REQUIRE_FALSE(diagnostics.has_errors());
    return *parsed.nodes.at(0).arguments.at(0).string();
}

}

TEST_CASE("a word needs no quotes")
{
    for (const char* word : {"a",
                             "a1",
                             "_1",
                             "-",
                             "--",
                             "-a",
                             "+",
                             "+a",
                             ".",
                             ".a",
                             "-.",
                             "-.a",
                             "..1",
                             "-..1",
                             "true-ish",
                             "nano",
                             "infinite",
                             "-info",
                             "a.b,c|d'e<f>g!h?i&j*k@l$m%n^o~p`q:r",
                             "größe",
                             "名前",
                             "😀"})
        CHECK(text_of(std::string("n ") + word) == word);
}

TEST_CASE("quotes hold any text of one line")
{
    CHECK(text_of("n \"\"") == "");
    CHECK(text_of("n \"a b; {c} // /* d=1 #\"") == "a b; {c} // /* d=1 #");
    CHECK(text_of("n \"true\"") == "true");
}

TEST_CASE("every escape stands for its character")
{
    CHECK(text_of(R"(n "\"\\\b\f\n\r\t\s")") == "\"\\\b\f\n\r\t ");
    CHECK(text_of(R"(n "\u{41}\u{e9}\u{20AC}\u{1F600}\u{10FFFF}\u{000041}")") == "Aé€😀\U0010FFFFA");
    CHECK(text_of(R"(n "\u{0}")") == std::string(1, '\0'));
}

TEST_CASE("escaped white space vanishes, new lines included")
{
    CHECK(text_of("n \"a\\   b\"") == "ab");
    CHECK(text_of("n \"a\\ \r\n\t \n b\"") == "ab");
    CHECK(text_of("n \"a\\\u3000\u2028b\"") == "ab");
}

TEST_CASE("wrong escapes are pointed at")
{
    CHECK(errors(R"(n "a\q")") == "1:5: \\q means nothing in a string\n");
    CHECK(hint(R"(n "a\q")") == "write \\\\ for a \\ in the text");
    CHECK(errors(R"(n "\/")") == "1:4: \\/ means nothing in a string\n");
    CHECK(hint(R"(n "\/")") == "write / as it is");
    CHECK(errors("n \"\\ß\"") == "1:4: \\ß means nothing in a string\n");
    CHECK(errors(R"(n "\N")") == "1:4: \\N means nothing in a string\n");
}

TEST_CASE("a code point escape has one to six digits in braces")
{
    const std::string rule = "1:4: \\u needs one to six hexadecimal digits in braces\n";
    for (const char* wrong : {R"(n "\u")", R"(n "\u41")", R"(n "\u{}")", R"(n "\u{41")", R"(n "\u{x}")",
                              R"(n "\u{0000041}")", R"(n "\u{4 1}")", R"(n "\u{+1}")"})
        CHECK(errors(wrong) == rule);
}

TEST_CASE("a code point escape names a scalar value")
{
    CHECK(errors(R"(n "\u{D800}")") == "1:4: there is no character \\u{D800}\n");
    CHECK(errors(R"(n "\u{dfff}")") == "1:4: there is no character \\u{dfff}\n");
    CHECK(errors(R"(n "\u{110000}")") == "1:4: there is no character \\u{110000}\n");
    CHECK(reading(R"(n "\u{D7FF}\u{E000}")") == "n \uD7FF\uE000\n");
}

TEST_CASE("raw strings hold escapes and quotes as they are")
{
    CHECK(text_of(R"(n #"\n \q \"#)") == "\\n \\q \\");
    CHECK(text_of(R"(n ##"a"#b"##)") == "a\"#b");
    CHECK(text_of("n #\"\"#") == "");
    CHECK(text_of("n ###\"x\"###") == "x");
    CHECK(text_of("n ##\"\"#\"##") == "\"#");
}

TEST_CASE("a string must be closed on its line")
{
    CHECK(errors("n \"abc") == "1:3: this string is not closed on its line\n");
    CHECK(hint("n \"abc") == "add a closing \", or use \"\"\" for a text of several lines");
    CHECK(errors("n \"abc\\\"\nm") == "1:3: this string is not closed on its line\n");
    CHECK(errors("n \"abc\\") == "1:3: this string is not closed on its line\n");
    CHECK(errors("n #\"abc\"\nm") == "1:3: this string is not closed on its line\n");
    CHECK(hint("n ##\"abc\"#\nm") == "add a closing \" with 2 # after it");
    CHECK(errors("n \"a\u2028b") == "1:3: this string is not closed on its line\n");
}

TEST_CASE("reserved words need # or quotes")
{
    CHECK(errors("n true") == "1:3: \"true\" is not a value\n");
    CHECK(hint("n true") == "write #true, or \"true\" for a text");
    for (const char* word : {"false", "null", "inf", "-inf", "nan"}) {
        CHECK(errors(std::string("n ") + word) == "1:3: \"" + std::string(word) + "\" is not a value\n");
        CHECK(errors(word) == "1:1: \"" + std::string(word) + "\" is not a value\n");
    }
}

TEST_CASE("the raw strings of KDL 1 are refused with the new form")
{
    CHECK(errors("n r\"a\\b\"") == "1:3: a raw string does not begin with r\n");
    CHECK(errors("n r#\"a\"#") == "1:3: a raw string does not begin with r\n");
    CHECK(hint("n r\"a\"") == "write #\"...\"#, as KDL 2.0 does");
    CHECK(reading("n r \"a\"") == "n r a\n");
}

TEST_CASE("a # begins a keyword or a raw string")
{
    CHECK(hint("n #maybe").starts_with("a text with a # needs quotes: \"#maybe\";"));
    CHECK(errors("n #maybe") == "1:3: \"#maybe\" is not a keyword\n");
    CHECK(errors("n #TRUE") == "1:3: \"#TRUE\" is not a keyword\n");
    CHECK(errors("n ##true") == "1:3: \"##true\" is not a keyword\n");
    CHECK(errors("n #") == "1:3: \"#\" is not a keyword\n");
    CHECK(errors("n #+inf") == "1:3: \"#+inf\" is not a keyword\n");
}

TEST_CASE("typographic quotes are letters, which is hardly meant")
{
    CHECK(errors("n \u201Cred\u201D") == "1:3: \u201C is read as a letter\n");
    CHECK(hint("n a=\u2018red\u2019") == "write \" around a text");
    CHECK(errors("n \u00E9").empty());
}
