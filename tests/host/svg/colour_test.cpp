#include "host/scene/context/colour_names.hpp"
#include "host/svg/style/colour.hpp"
#include "tests/host/svg/drawing_text.hpp"

#include <algorithm>
#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::test;

namespace {

std::string ink(std::string_view text)
{
    const auto found = svg::colour(text);
    return found ? hex(found->colour) + ' ' + std::to_string(std::lround(100 * found->opacity)) : "none";
}

}

TEST_CASE("all ways to write a colour")
{
    CHECK(ink("#f80") == "#ff8800 100");
    CHECK(ink("#f808") == "#ff8800 53");
    CHECK(ink("#FF8040") == "#ff8040 100");
    CHECK(ink("#ff804080") == "#ff8040 50");
    CHECK(ink("rgb(255, 128,0)") == "#ff8000 100");
    CHECK(ink("rgb(100%,50%,0%)") == "#ff8000 100");
    CHECK(ink("rgba(255,128,0,.25)") == "#ff8000 25");
    CHECK(ink("rgb(255 128 0 / 25%)") == "#ff8000 25");
    CHECK(ink("rgb(0 50% 0)") == "#008000 100");
    CHECK(ink("RGB(300,-5,0)") == "#ff0000 100");
    CHECK(ink("hsl(120, 100%, 25%)") == "#008000 100");
    CHECK(ink("hsla(0.5turn,100%,50%,0.5)") == "#00ffff 50");
    CHECK(ink("hsl(-120 100% 50%)") == "#0000ff 100");
    CHECK(ink(" DarkOrange ") == "#ff8c00 100");
    CHECK(ink("transparent") == "#000000 0");
}

TEST_CASE("what is no colour")
{
    for (const char* text : {"", "blurple", "#12", "#12345", "rgb(1,2)", "rgb(1,2,3", "rgb(a,b,c)", "hsl()",
                             "rgb 1", "rgb(0,50%,0)"})
        CHECK_MESSAGE(ink(text) == "none", text);
}

TEST_CASE("names of colours can be searched by halves")
{
    CHECK(std::ranges::is_sorted(scene::colour_names, {}, &scene::NamedColour::name));
    for (const auto& named : scene::colour_names)
        CHECK_MESSAGE(ink(named.name) != "none", named.name);
}
