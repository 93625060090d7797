#include "host/scene_text/values/writing.hpp"

#include <doctest/doctest.h>

namespace kfast::scene_text {

TEST_CASE("names are kept, and numbered where they come again")
{
    Names names;
    CHECK(names.unique("eye", "shape") == "eye");
    CHECK(names.unique("eye-2", "shape") == "eye-2");
    CHECK(names.unique("eye", "shape") == "eye-3");
    CHECK(names.unique("eye", "shape") == "eye-4");
    CHECK(names.unique("", "shape") == "shape");
    CHECK(names.unique("\n", "shape") == "shape-2");
    CHECK(names.unique("Größe 2", "shape") == "Größe 2");
}

TEST_CASE("a reserved name is never given")
{
    Names names;
    names.reserve("white");
    CHECK(names.unique("white", "colour") == "white-2");
}

TEST_CASE("names hold neither control characters nor what is no UTF-8")
{
    CHECK(clean_name("a\nb\x7f", "x") == "a b");
    CHECK(clean_name("a\xff"
                     "b",
                     "x") == "a b");
    CHECK(clean_name("\xe2\x80\xae"
                     "a",
                     "x") == "a"); // turns the direction of writing round
}

TEST_CASE("names have at most 255 bytes, and end with a whole character")
{
    std::string umlauts;
    for (int i = 0; i < 200; ++i)
        umlauts += "ä";
    CHECK(clean_name(umlauts, "x").size() == 254);
    Names names;
    names.unique(umlauts, "x");
    const std::string second = names.unique(umlauts, "x");
    CHECK(second.size() == 254);
    CHECK(second.ends_with("ä-2"));
}

TEST_CASE("many equal names take no long time")
{
    Names names;
    for (int i = 0; i < 60'000; ++i)
        names.unique("g", "x");
    CHECK(names.unique("g", "x") == "g-60001");
}

}
