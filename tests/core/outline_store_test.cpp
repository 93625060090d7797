#include "core/outline_store.hpp"

#include <cstddef>
#include <doctest/doctest.h>
#include <vector>

namespace kfast::test {
namespace {

Corner at(int x, int y) { return {Fixed::pixels(x), y * subrows}; }

struct Store {
    std::vector<std::uint32_t> memory;
    OutlineStore outlines;

    explicit Store(std::size_t bytes = 4096)
        : memory(bytes / 4), outlines{std::as_writable_bytes(std::span{memory}), 100}
    {
    }

    OutlineRange add(const std::vector<Corner>& corners)
    {
        const OutlineRange mark = outlines.mark();
        for (const Corner corner : corners)
            outlines.add(corner);
        outlines.close();
        return outlines.range_from(mark);
    }
};

TEST_CASE("a contour falls into chains that do not turn back")
{
    Store store;
    store.add({at(0, 10), at(10, 20), at(10, 30), at(0, 40), at(-10, 20)});
    REQUIRE(store.outlines.mark().end_chain == 2);
    const Chain& down = store.outlines.chain(0);
    CHECK(int{down.edges} == 3);
    CHECK(down.winding() == 1);
    CHECK(store.outlines.corner(down.first) == at(0, 10));
    const Chain& up = store.outlines.chain(1);
    CHECK(int{up.edges} == 2);
    CHECK(up.winding() == -1);
    CHECK(store.outlines.corner(up.first) == at(0, 10));
}

TEST_CASE("level edges end no chain and begin none")
{
    Store store;
    store.add({at(0, 0), at(10, 0), at(10, 5), at(20, 5), at(20, 9), at(0, 9)});
    REQUIRE(store.outlines.mark().end_chain == 2);
    CHECK(int{store.outlines.chain(0).edges} == 3);
    CHECK(int{store.outlines.chain(1).edges} == 1);
    Store flat;
    CHECK(flat.add({at(0, 3), at(9, 3), at(4, 3)}).empty());
}

TEST_CASE("corners added behind follow those added, the last one first")
{
    Store store;
    store.outlines.add(at(0, 0));
    store.outlines.add_behind(at(1, 0));
    store.outlines.add(at(0, 5));
    store.outlines.add_behind(at(1, 5));
    store.outlines.close();
    REQUIRE(store.outlines.mark().end_corner == 5);
    CHECK(store.outlines.corner(1) == at(0, 5));
    CHECK(store.outlines.corner(2) == at(1, 5));
    CHECK(store.outlines.corner(3) == at(1, 0));
    CHECK(store.outlines.corner(4) == at(0, 0));
}

TEST_CASE("chains above and below the rows are left out")
{
    Store store;
    CHECK(store.add({at(0, -20), at(10, -10), at(-10, 0)}).empty());
    CHECK(store.add({at(0, 100), at(10, 110), at(-10, 120)}).empty());
    CHECK_FALSE(store.add({at(0, -10), at(10, 110), at(-10, 50)}).empty());
}

TEST_CASE("what finds no room is told and leaves the rest alone")
{
    for (std::size_t bytes = 0; bytes < 5 * sizeof(Corner) + 2 * sizeof(Chain); bytes += 4) {
        Store store{bytes};
        store.add({at(0, 0), at(9, 9), at(0, 9)});
        CHECK(store.outlines.is_full() == (bytes < 4 * sizeof(Corner) + 2 * sizeof(Chain)));
        CHECK(store.outlines.used_bytes() <= bytes);
    }
}

TEST_CASE("a range is sorted by the upper ends, and copied with them")
{
    Store store;
    store.add({at(0, 1), at(1, 2), at(0, 3)});
    const OutlineRange mark = store.outlines.mark();
    for (const int top : {50, 20, 70, 10, 40, 30, 60}) {
        store.outlines.add(at(0, top));
        store.outlines.add(at(5, top + 5));
        store.outlines.add(at(0, top + 7));
        store.outlines.close();
    }
    const OutlineRange range = store.outlines.range_from(mark);
    store.outlines.sort(range);
    Store other;
    other.add({at(3, 3), at(4, 4), at(1, 6)});
    const OutlineRange copied = other.outlines.copy(store.outlines, range);
    REQUIRE(copied.end_chain - copied.first_chain == 14);
    for (std::uint16_t i = 0; i < 14; ++i) {
        const auto top = [](OutlineStore& outlines, std::uint16_t chain) {
            return outlines.corner(outlines.chain(chain).first);
        };
        const auto number = static_cast<std::uint16_t>(copied.first_chain + i);
        CHECK(top(other.outlines, number) ==
              top(store.outlines, static_cast<std::uint16_t>(range.first_chain + i)));
        if (i > 0)
            CHECK(top(other.outlines, static_cast<std::uint16_t>(number - 1)).y <=
                  top(other.outlines, number).y);
    }
}

}
}
