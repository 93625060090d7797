#include "core/scene/track_view.hpp"

#include "core/scene/kfb_limits.hpp"
#include "tests/core/raw_scene.hpp"

#include <doctest/doctest.h>
#include <random>

namespace kfast::test {
namespace {

KeyTimeCursor taken(const Bytes& bytes)
{
    ByteReader reader{bytes};
    return KeyTimeCursor::take(reader, {});
}

void check_same(KeyTimeCursor cursor, const KeyTimes& key_times)
{
    REQUIRE(cursor.count() == key_times.size());
    for (std::size_t i = 0; i < key_times.size(); ++i) {
        REQUIRE_FALSE(cursor.at_end());
        const KeyTime key_time = cursor.next();
        CHECK(key_time.time == key_times[i].time);
        CHECK(key_time.laws == key_times[i].laws);
        CHECK(key_time.index == i);
    }
    CHECK(cursor.at_end());
}

}

TEST_CASE("times are counted from the beat before, in the unit of the form")
{
    // 3 bits for times in frames, 2 for laws: 1, 1; 2, 2
    const Bytes key_times = bytes({2, 0x43, 0x05, 0x2A, 0x80, 99});
    ByteReader reader{key_times};
    check_same(KeyTimeCursor::take(reader, {}), {{Time::frame(1), 1}, {Time::frame(3), 2}});
    CHECK(reader.left() == 1);
    CHECK_FALSE(reader.overrun());
}

TEST_CASE("the usual beats take one byte")
{
    const Bytes none = bytes({0, 99});
    ByteReader reader{none};
    check_same(KeyTimeCursor::take(reader, KeyTimeCursor::one()), {{}});
    CHECK(reader.left() == 1);
    CHECK(taken(none).at_end());
    CHECK(taken(none).count() == 0);
    CHECK(key_time_bytes({}).size() == 1);
}

TEST_CASE("what is written is read back")
{
    std::mt19937 random{61};
    for (int round = 0; round < 3000; ++round) {
        const auto bits = 1 + random() % 24;
        const std::int32_t unit = 1 << random() % 12;
        KeyTimes key_times(1 + random() % 12);
        Time time{static_cast<std::int32_t>(random() % 2) * 5 * unit};
        for (WrittenKeyTime& key_time : key_times) {
            key_time = {time, static_cast<std::uint32_t>(random() % (round % 2 == 0 ? 1 : 256))};
            time.ticks +=
                static_cast<std::int32_t>(1 + random() % (1U << bits) / static_cast<unsigned>(unit)) * unit;
        }
        const Bytes bytes = key_time_bytes(key_times);
        ByteReader reader{bytes};
        check_same(KeyTimeCursor::take(reader, {}), key_times);
        CHECK(reader.left() == 0);
        CHECK_FALSE(reader.overrun());
    }
}

TEST_CASE("eight keys in step take two bytes and four bits each")
{
    KeyTimes key_times;
    for (int i = 0; i < 8; ++i)
        key_times.push_back({{i * 7680}, 0});
    CHECK(key_time_bytes(key_times).size() == 1 + 2 + 4);
}

TEST_CASE("the latest time of the format is kept")
{
    check_same(taken(key_time_bytes({{Time{kfb::max_time}, 3}})), {{Time{kfb::max_time}, 3}});
}

TEST_CASE("beats say which input they count, and the usual ones that of where they come from")
{
    const Bytes by_input = key_time_bytes({{Time{0}, 1}, {Time{65536}, 2}}, {32});
    CHECK(by_input.size() == key_time_bytes({{Time{0}, 1}, {Time{65536}, 2}}).size() + 1);
    check_same(taken(by_input), {{Time{0}, 1}, {Time{65536}, 2}});
    CHECK(taken(by_input).driver() == Driver{32});
    CHECK(taken(key_time_bytes({{Time{5}, 1}})).driver().is_time());
    const Bytes default_value = bytes({0});
    ByteReader reader{default_value};
    CHECK(KeyTimeCursor::take(reader, taken(by_input)).driver() == Driver{32});
}

TEST_CASE("beats that break off, or have a form without a meaning, are past the end")
{
    const auto is_whole = [](const Bytes& bytes) {
        ByteReader reader{bytes};
        KeyTimeCursor::take(reader, {});
        return !reader.overrun();
    };
    CHECK(is_whole(bytes({2, 0x43, 0x05, 0x2B, 0x80})));
    CHECK_FALSE(is_whole(bytes({2, 0x43, 0x05, 0x2B})));
    CHECK_FALSE(is_whole(bytes({2, 0x43})));
    CHECK_FALSE(is_whole(bytes({2})));
    CHECK_FALSE(is_whole({}));
    CHECK(is_whole(bytes({1, 0x00, 8 << 1, 0xFF})));
    CHECK_FALSE(is_whole(bytes({1, 0x00, 9 << 1, 0xFF, 0xFF})));       // laws have numbers of 8 bits
    CHECK_FALSE(is_whole(joined({bytes({1, 0x5E, 0x01}), Bytes(4)}))); // times of 30 bits, and ten more
    CHECK(is_whole(joined({bytes({1, 0x54, 0x01}), Bytes(3)})));       // of 20 and ten
    CHECK_FALSE(is_whole(joined({bytes({1, 0x1F, 0x00}), Bytes(4)}))); // of 31
    CHECK(is_whole(bytes({1, 0x00, 0x80, 1})));
    CHECK_FALSE(is_whole(bytes({1, 0x00, 0x80}))); // by an input, but which?
    CHECK_FALSE(is_whole(bytes({1, 0x00, 0x80, 0})));
    CHECK_FALSE(is_whole(bytes({0xFF, 0xFF, 0xFF, 0xFF, 0x0F, 0x1F, 0x10, 0, 0, 0, 0})));
}

TEST_CASE("beats of a form without a meaning are read without harm")
{
    for (int law_bits = 9; law_bits < 64; ++law_bits) {
        const int form = law_bits << 9;
        KeyTimeCursor key_times =
            taken(joined({bytes({3, form & 0xFF, form >> 8}), Bytes(60, std::byte{0xFF})}));
        while (!key_times.at_end())
            CHECK(key_times.next().laws == 0);
    }
}

}
