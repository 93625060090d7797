#include "core/paint_order.hpp"

#include "tests/core/raw_scene.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <random>
#include <string>
#include <vector>

namespace kfast::test {
namespace {

/// A use whose symbol is the letter that order_text() writes, with a track or none.
Bytes letter(char name, const Bytes& track = {})
{
    return track.empty() ? bytes({2, name}) : joined({bytes({6, 1}), track, bytes({name})});
}

Bytes ordered(char name, int order) { return letter(name, fixed_track(Property::order, order)); }

std::string order_text(const Bytes& items, Time time = {})
{
    std::string text;
    PaintOrder order{ItemCursor{ByteReader{items}}, time};
    while (const auto item = order.next())
        text += static_cast<char>(item->symbol);
    CHECK_FALSE(order.next());
    return text;
}

}

TEST_CASE("without tracks items are painted as they lie")
{
    CHECK(order_text({}).empty());
    CHECK(order_text(joined({letter('c'), letter('a'), letter('b')})) == "cab");
    CHECK(order_text(joined({letter('c', fixed_track(Property::x, -5)), letter('a')})) == "ca");
}

TEST_CASE("the lowest order is painted first, and of equals the first")
{
    CHECK(order_text(joined({ordered('a', 2), ordered('b', 1), ordered('c', 2), ordered('d', 1)})) == "bdac");
    CHECK(order_text(joined({ordered('a', 1), letter('b'), ordered('c', -1), letter('d')})) == "cbda");
    CHECK(order_text(joined({ordered('a', 32767), ordered('b', -32768), ordered('c', 32767),
                             ordered('d', -32768)})) == "bdac");
    CHECK(order_text(ordered('a', 7)) == "a");
}

TEST_CASE("the order changes with time")
{
    const Bytes items =
        joined({letter('a'),
                letter('b', moving_track(Property::order, {{Time::frame(2), 0, 0}, {Time::frame(4), 0, -1}})),
                letter('c', moving_track(Property::order, {{{}, 0, 3}, {Time::frame(6), 0, -2}}))});
    CHECK(order_text(items) == "abc");
    CHECK(order_text(items, {4 * 1024 - 1}) == "abc");
    CHECK(order_text(items, Time::frame(4)) == "bac");
    CHECK(order_text(items, Time::frame(6)) == "cba");
}

TEST_CASE("items are ordered among those beside them only")
{
    const Bytes inside = joined({ordered('x', 9), ordered('y', -9)});
    const Bytes items = joined({group(inside), ordered('b', -1)});
    PaintOrder order{ItemCursor{ByteReader{items}}, {}};
    CHECK(order.next()->symbol == 'b');
    const auto last = order.next();
    REQUIRE(last->kind == ItemKind::group);
    CHECK_FALSE(order.next());
    PaintOrder deeper{ItemCursor{last->items}, {}};
    CHECK(deeper.next()->symbol == 'y');
    CHECK(deeper.next()->symbol == 'x');
    CHECK_FALSE(deeper.next());
}

TEST_CASE("any orders are those of a stable sort")
{
    std::mt19937 random{61};
    for (int round = 0; round < 300; ++round) {
        std::vector<std::pair<int, char>> sorted;
        Bytes items;
        for (auto name = 'a'; name <= 'z'; ++name) {
            const int order = static_cast<int>(random() % 7) - 3;
            items = joined({items, order == 0 ? letter(name) : ordered(name, order)});
            sorted.emplace_back(order, name);
        }
        std::ranges::stable_sort(sorted, {}, &std::pair<int, char>::first);
        std::string expected;
        for (const auto& [order, name] : sorted)
            expected += name;
        REQUIRE(order_text(items) == expected);
    }
}

}
