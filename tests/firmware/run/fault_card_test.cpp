#include "firmware/run/fault_card.hpp"

#include "tests/firmware/run/drawn_card.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("a fault is shown as E and its number")
{
    CHECK(drawn<PixelFormat::mono1>(FaultCard{Error::bad_checksum, {9, 7}}, {9, 7}) ==
          std::vector<std::string>{
              ".........", //
              ".###.#.#.", //
              ".#...#.#.", //
              ".###.###.", //
              ".#.....#.", //
              ".###...#.", //
              ".........",
          });
    CHECK(drawn<PixelFormat::rgb565>(FaultCard{Error::block_too_small, {9, 7}}, {9, 7}) ==
          std::vector<std::string>{
              ".........", //
              ".###.###.", //
              ".#...#...", //
              ".###.###.", //
              ".#...#.#.", //
              ".###.###.", //
              ".........",
          });
}

TEST_CASE("numbers of faults have up to two digits")
{
    CHECK(drawn<PixelFormat::mono1>(FaultCard{Error::needs_strokes, {13, 7}}, {13, 7}) ==
          std::vector<std::string>{
              ".............", //
              ".###.###.#.#.", //
              ".#...#...#.#.", //
              ".###.###.###.", //
              ".#...#.#...#.", //
              ".###.###...#.", //
              ".............",
          });
}

TEST_CASE("without room for words a fault is as large as the panel allows, in its middle")
{
    CHECK(drawn<PixelFormat::grey4>(FaultCard{Error::truncated, {20, 17}}, {20, 17}) ==
          std::vector<std::string>{
              "....................", //
              "....................", //
              "....................", //
              "...######....##.....", //
              "...######....##.....", //
              "...##......####.....", //
              "...##......####.....", //
              "...######....##.....", //
              "...######....##.....", //
              "...##........##.....", //
              "...##........##.....", //
              "...######..######...", //
              "...######..######...", //
              "....................", //
              "....................", //
              "....................", //
              "....................",
          });
}

TEST_CASE("where there is room the lower half says in words what is wrong")
{
    const auto rows = drawn<PixelFormat::grey4>(FaultCard{Error::bad_magic, {128, 64}}, {128, 64});
    Card expected{{128, 64}};
    expected.add("E2", 5, 7);
    expected.add("bad_magic: not a", 2, 40);
    expected.add("compiled scene", 2, 52);
    CHECK(rows == drawn<PixelFormat::grey4>(expected, {128, 64}));
}

TEST_CASE("a panel that is too small for a fault is black")
{
    CHECK(drawn<PixelFormat::grey4>(FaultCard{Error::truncated, {8, 2}}, {8, 2}) ==
          std::vector<std::string>(2, "........"));
}

TEST_CASE("texts are broken at spaces")
{
    std::array<std::string_view, 3> lines;
    CHECK(wrap("one two three", 7, lines) == 2);
    CHECK(lines[0] == "one two");
    CHECK(lines[1] == "three");
    CHECK(wrap("one two three", 5, lines) == 3);
    CHECK(wrap("one two three", 4, lines) == 0); // too long a word
    CHECK(wrap("a b c d", 1, lines) == 0);       // too many lines
}

TEST_CASE("every error finds room for its words on the panels that people have")
{
    for (int number = 1; number <= 6; ++number)
        for (const Size panel : {Size{128, 64}, Size{128, 160}, Size{240, 240}, Size{320, 240}}) {
            const auto rows = drawn<PixelFormat::mono1>(FaultCard{static_cast<Error>(number), panel}, panel);
            int lit = 0;
            for (int y = panel.height / 2; y < panel.height; ++y)
                lit += static_cast<int>(std::ranges::count(rows[static_cast<std::size_t>(y)], '#'));
            CHECK(lit > 100);
        }
}

}
