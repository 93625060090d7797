#include "firmware/slots/slot_pool.hpp"

#include <doctest/doctest.h>

#include <initializer_list>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

constexpr std::uint32_t sectors(std::uint32_t count) { return count * sector_bytes; }

struct Piece {
    std::uint32_t sector = 0;
    std::uint32_t size = 0;
};

SlotDirectory directory_of(std::initializer_list<Piece> pieces)
{
    SlotDirectory directory;
    std::size_t slot = 0;
    for (const Piece& piece : pieces)
        directory.slots[slot++] = {{}, sectors(piece.sector), piece.size, 0};
    return directory;
}

SlotPool pool_of(std::initializer_list<Piece> pieces, Extent held = {})
{
    return {directory_of(pieces), sectors(10), held};
}

}

TEST_CASE("an empty pool has room for all of it and no more")
{
    CHECK(pool_of({}).longest_room() == sectors(10));
    CHECK(pool_of({}).room_for(sectors(10), 0) == 0);
    CHECK_FALSE(pool_of({}).room_for(sectors(10) + 1, 0));
    CHECK_FALSE(pool_of({}).room_for(0xFFFFFFFF, sectors(3)));
}

TEST_CASE("room is looked for behind what was written last, and then from the beginning")
{
    const SlotPool pool = pool_of({{1, sectors(2)}, {5, 1}});
    CHECK(pool.room_for(1, sectors(3)) == sectors(3));
    CHECK(pool.room_for(sectors(2), sectors(1)) == sectors(3));
    CHECK(pool.room_for(sectors(2) + 1, sectors(1)) == sectors(6));
    CHECK(pool.room_for(sectors(4), sectors(8)) == sectors(6));
    CHECK(pool.room_for(1, sectors(10)) == 0);
    CHECK(pool.room_for(sectors(1), sectors(9)) == sectors(9));
    CHECK_FALSE(pool.room_for(sectors(4) + 1, 0));
    CHECK(pool.longest_room() == sectors(4));
}

TEST_CASE("what is held is no room, even where no slot has it, in whole sectors")
{
    CHECK(pool_of({}, {sectors(4) - 1, sectors(6) + 1}).longest_room() == sectors(3));
    CHECK(pool_of({}, {sectors(4), sectors(10)}).room_for(sectors(4), sectors(2)) == 0);
    CHECK(pool_of({{0, sectors(5)}}, {sectors(2), sectors(3)}).longest_room() == sectors(5));
}

TEST_CASE("room never overlaps what is occupied, and is found if there is any")
{
    std::mt19937 engine{1};
    const auto below = [&](std::uint32_t end) { return static_cast<std::uint32_t>(engine() % end); };
    for (int round = 0; round < 20000; ++round) {
        std::vector<bool> taken(10);
        SlotDirectory directory;
        const std::size_t count = below(5);
        for (std::size_t slot = 0; slot < count; ++slot) {
            const std::uint32_t begin = below(10);
            const std::uint32_t size = below(sectors(10 - begin));
            if (size == 0)
                continue;
            directory.slots[slot] = {{}, sectors(begin), size, 0};
            for (std::uint32_t at = begin; at * sector_bytes < sectors(begin) + size; ++at)
                taken[at] = true;
        }
        const std::uint32_t size = 1 + below(sectors(10));
        const SlotPool pool{directory, sectors(10), {}};
        const auto room = pool.room_for(size, sectors(below(11)));
        CHECK(room.has_value() == (size <= pool.longest_room()));
        for (std::uint32_t at = 0; room && at < size; at += sector_bytes)
            CHECK_FALSE(taken.at((*room + at) / sector_bytes));
    }
}

}
