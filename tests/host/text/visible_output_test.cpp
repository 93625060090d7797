#include "host/text/visible_output.hpp"

#include "host/text/characters.hpp"

#include <doctest/doctest.h>

#include <random>
#include <sstream>

namespace kfast::test {
namespace {

/// What comes out of what is written in these parts.
std::string written(std::initializer_list<std::string_view> parts)
{
    std::stringbuf sink;
    {
        VisibleBuffer buffer{sink};
        std::ostream out{&buffer};
        for (const std::string_view part : parts)
            out << part << std::flush;
    }
    return sink.str();
}

}

TEST_CASE("text, line ends and tabs pass as they are")
{
    CHECK(written({"lamp ä€😀\n\tx"}) == "lamp ä€😀\n\tx");
}

TEST_CASE("what a terminal would obey is shown")
{
    CHECK(written({"\x1B[31m\a\r\x7F"}) == "<U+001B>[31m<U+0007><U+000D><U+007F>");
    CHECK(written({"\u009B2J\u202Ex"}) == "<U+009B>2J<U+202E>x");
    CHECK(written({"\xFF", "\x9B"}) == "<0xFF><0x9B>");
}

TEST_CASE("a code point may come in parts")
{
    CHECK(written({"\xC2", "\x9B"}) == "<U+009B>");
    CHECK(written({"\xF0", "\x9F", "\x98", "\x80"}) == "😀");
    CHECK(written({"\xE2\x80"}) == "<0xE2><0x80>");
    CHECK(written({"\xE2", "x"}) == "<0xE2>x");
    CHECK(written({"\xE2", "\xC2", "\x9B"}) == "<0xE2><U+009B>");
}

TEST_CASE("any bytes come out as visible() has them, however they are divided")
{
    std::mt19937 random{1};
    for (int round = 0; round < 2000; ++round) {
        std::string text;
        for (auto left = random() % 20; left > 0; --left)
            text += static_cast<char>("\x1B\xC2\x9B\xE2\x80\xAE\xF0\x9Fx\x7F"[random() % 10]);
        const std::size_t middle = random() % (text.size() + 1);
        const std::string_view all = text;
        CHECK(written({all.substr(0, middle), all.substr(middle)}) == visible(text));
    }
}

TEST_CASE("sequences of our own pass")
{
    std::stringbuf sink;
    VisibleBuffer buffer{sink};
    std::ostream out{&buffer};
    write_as_is(out, "\x1B[1m");
    out << "\x1B[0m";
    std::ostringstream plain;
    write_as_is(plain, "\r");
    CHECK(sink.str() == "\x1B[1m<U+001B>[0m");
    CHECK(plain.str() == "\r");
}

TEST_CASE("a sink that takes nothing is told")
{
    class Full final : public std::streambuf {
    } full;
    VisibleBuffer buffer{full};
    std::ostream out{&buffer};
    out << "x";
    CHECK_FALSE(out.good());
}

}
