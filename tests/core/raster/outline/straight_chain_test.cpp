#include "core/raster/outline/chain.hpp"
#include "core/raster/outline/outline_store.hpp"
#include "tests/core/raster/outline/chain_lines.hpp"
#include "tests/rounds.hpp"

#include <cstddef>
#include <cstdint>
#include <doctest/doctest.h>
#include <random>
#include <span>
#include <utility>
#include <vector>

/// Chains that are a single long edge.
namespace kfast::test {
namespace {

raster::Corner on_grid(int x, int y) { return {x * raster::grid, y * raster::grid}; }

/// Of the edge alone, as if it were not high.
std::vector<raster::Crossing> built(raster::Corner top, raster::Corner bottom, int left)
{
    std::vector<std::uint32_t> memory(2000);
    const raster::Corner edge[]{top, bottom};
    raster::ChainBuilder builder;
    REQUIRE(builder.build(&edge[0], &edge[1], 1, left * raster::grid,
                          std::as_writable_bytes(std::span{memory}).data() + 4 * memory.size()));
    const auto count =
        static_cast<std::size_t>(raster::ceil_pixel(bottom.y) - raster::floor_pixel(top.y) + 1);
    return {builder.crossings(), builder.crossings() + count};
}

TEST_CASE("a high edge is straight, and its crossings are those that would be stored else")
{
    constexpr Size panel{400, 400};
    std::mt19937 random{14};
    std::uniform_int_distribution<int> place{0, 400 * raster::grid};
    int straight = 0;
    for (int round = 0; round < rounds(2000); ++round) {
        raster::Corner top{place(random), place(random)};
        raster::Corner bottom{place(random), place(random)};
        if (top.y > bottom.y)
            std::swap(top, bottom);
        if (bottom.y - top.y <= 41 * raster::grid)
            continue;
        OwnedOutlines outlines{panel, 1 << 14, round % 4};
        outlines.add({top, bottom});
        const raster::OutlineStore& store = outlines.store();
        store.each_chain([&](const raster::Chain& chain) {
            ++straight;
            CHECK(bool{chain.is_straight});
            CHECK((chain.top == top.y && chain.bottom == bottom.y));
            CHECK(crossings_of(store, chain) == built(top, bottom, chain.left));
        });
    }
    CHECK(straight > rounds(2000));
}

TEST_CASE("a chain of one edge is straight if this takes less memory than its crossings")
{
    for (int rows = 1; rows < 60; ++rows) {
        OwnedOutlines outlines{Size{100, 100}};
        outlines.add({on_grid(3, 20), on_grid(70, 20 + rows)});
        outlines.store().each_chain([rows](const raster::Chain& chain) {
            const std::size_t bytes = raster::OutlineStore::chain_bytes(chain);
            CHECK(bytes == sizeof(raster::Chain) +
                               (chain.is_straight
                                    ? sizeof(raster::StraightLine)
                                    : sizeof(raster::Bend) +
                                          raster::ChainBuilder::crossing_bytes(chain.top, chain.bottom)));
            CHECK(bytes <= 40 + 4 + 2 * (static_cast<std::size_t>(rows) + 1) + 2);
            CHECK(bytes <= 40 + 28);
        });
    }
}

TEST_CASE("a high edge among others is a chain of its own")
{
    const std::vector<raster::Corner> contour{on_grid(10, 0),  on_grid(14, 4),  on_grid(20, 10),
                                              on_grid(30, 90), on_grid(27, 95), on_grid(25, 100),
                                              on_grid(0, 100)};
    OwnedOutlines outlines{Size{100, 100}};
    outlines.add(contour);
    int straight = 0;
    int others = 0;
    outlines.store().each_chain(
        [&](const raster::Chain& chain) { ++(chain.is_straight ? straight : others); });
    CHECK(straight == 2);
    CHECK(others == 2);
    CHECK(outlines.store().needed_bytes() < 500);
}

}
}
