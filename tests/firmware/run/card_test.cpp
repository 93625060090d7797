#include "firmware/run/card.hpp"

#include "tests/firmware/run/drawn_card.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("a card's lines stand in the middle of the panel's width, as large as they are asked to be")
{
    Card card{{24, 12}};
    card.add("A1", 2, 1);
    CHECK(drawn<PixelFormat::grey4>(card, {24, 12}) == std::vector<std::string>{
                                                           "........................", //
                                                           ".......##......##.......", //
                                                           ".......##......##.......", //
                                                           ".....##..##..####.......", //
                                                           ".....##..##..####.......", //
                                                           ".....######....##.......", //
                                                           ".....######....##.......", //
                                                           ".....##..##....##.......", //
                                                           ".....##..##....##.......", //
                                                           ".....##..##..######.....", //
                                                           ".....##..##..######.....", //
                                                           "........................", //
                                                       });
}

TEST_CASE("small letters look like capitals, a line is a space, unknown signs are blocks")
{
    CHECK(small_font::blocks('q') == small_font::blocks('Q'));
    CHECK(small_font::blocks('_') == 0);
    CHECK(small_font::blocks(' ') == 0);
    CHECK(small_font::blocks('?') == 077777);
    CHECK(small_font::blocks('\xE4') == 077777);
}

TEST_CASE("no two letters look alike")
{
    const std::string_view signs = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.,:-/^";
    for (const char a : signs)
        for (const char b : signs)
            CHECK((a == b || small_font::blocks(a) != small_font::blocks(b)));
}

}
