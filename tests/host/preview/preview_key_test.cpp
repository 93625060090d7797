#include "host/preview/controls/preview_key.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace kfast::test {
namespace {

bool is_listed(PreviewFront front, const std::string& name)
{
    return std::ranges::any_of(preview_key_help(front),
                               [&](const std::string& line) { return line.find(name + ' ') == 0; });
}

}

TEST_CASE("keys have names")
{
    CHECK(preview_key("space") == PreviewKey::play_pause);
    CHECK(preview_key("escape") == PreviewKey::leave);
    CHECK(preview_key("?") == preview_key("h"));
    CHECK_FALSE(preview_key("7").has_value());
    CHECK(preview_key_help(PreviewFront::window).front() ==
          "space      play, pause; after 'a' the next frame");
}

TEST_CASE("the help of a window ends with its mouse, which is no key, and a terminal has none")
{
    CHECK(preview_help(PreviewFront::window).back().starts_with("mouse      click an object"));
    CHECK_FALSE(is_listed(PreviewFront::window, "mouse"));
    CHECK(preview_help(PreviewFront::terminal) == preview_key_help(PreviewFront::terminal));
}

TEST_CASE("the help of a terminal has no keys of which nothing is seen there")
{
    for (const char* const name : {"k", "m", "d", "f", "e", "y", "u", "z", "x"}) {
        CHECK(is_listed(PreviewFront::window, name));
        CHECK_FALSE(is_listed(PreviewFront::terminal, name));
        CHECK_FALSE(works_in(PreviewFront::terminal, *preview_key(name)));
    }
    for (const char* const name :
         {"space", "n", "r", "o", "t", "w", "tab", "enter", "s", "g", "h", "q", "escape"}) {
        CHECK(is_listed(PreviewFront::terminal, name));
        CHECK(works_in(PreviewFront::terminal, *preview_key(name)));
    }
}

}
