#include "core/bytes/picture_cache.hpp"

#include <algorithm>
#include <doctest/doctest.h>
#include <map>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

PictureCache::Name name_of(std::uint32_t number) { return {number, 7, 0}; }

using Incoming = PictureCache::Incoming;

/// `count` words that tell the number of their set.
bool keep(PictureCache& cache, std::uint32_t number, std::size_t count,
          Incoming incoming = Incoming::replaces_next)
{
    cache.begin(name_of(number), incoming);
    for (std::size_t i = 0; i < count; ++i)
        if (std::uint32_t* const word = cache.add(1))
            *word = number;
    return cache.end(true) != nullptr;
}

bool is_kept(PictureCache& cache, std::uint32_t number, std::size_t count)
{
    const std::uint32_t* const words = cache.find(name_of(number));
    if (words == nullptr)
        return false;
    CHECK(cache.count() == count);
    CHECK(std::all_of(words, words + count, [number](std::uint32_t word) { return word == number; }));
    return true;
}

/// Memory for so many sets of three words each, and not for one more.
struct Room {
    static constexpr std::size_t set_bytes = 16 + 3 * 4;

    explicit Room(std::size_t sets)
        : words(sets * set_bytes / 4 + 1), cache{std::as_writable_bytes(std::span{words})}
    {
    }

    bool keep(std::uint32_t number) { return test::keep(cache, number, 3); }
    bool has(std::uint32_t number) { return is_kept(cache, number, 3); }

    std::vector<std::uint32_t> words;
    PictureCache cache;
};

TEST_CASE("sets are found by their whole names, and what is not complete or finds no room is not kept")
{
    Room room{2};
    CHECK_FALSE(room.has(1));
    CHECK(room.keep(1));
    CHECK(room.has(1));
    CHECK(room.cache.find({1, 8, 0}) == nullptr);
    CHECK(room.cache.find({1, 7, 1}) == nullptr);
    room.cache.begin(name_of(2), Incoming::beside_others);
    CHECK(room.cache.add(3) != nullptr);
    CHECK(room.cache.end(false) == nullptr);
    CHECK_FALSE(room.has(2));
    CHECK_FALSE(keep(room.cache, 3, 8));
    CHECK(room.keep(4));
    CHECK(room.has(1));
    CHECK(room.has(4));
    PictureCache none;
    CHECK_FALSE(keep(none, 1, 0));
    CHECK(none.find(name_of(1)) == nullptr);
}

TEST_CASE("a set without words is kept, too")
{
    Room room{1};
    CHECK(keep(room.cache, 5, 0));
    CHECK(is_kept(room.cache, 5, 0));
}

TEST_CASE("what comes in takes the place of the next set that the picture has not wanted, and of no other")
{
    Room room{3};
    for (const std::uint32_t number : {1U, 2U, 3U})
        CHECK(room.keep(number));
    CHECK(room.cache.bytes_in_use() == 3 * Room::set_bytes);
    CHECK_FALSE(room.keep(9)); // all are of use in this picture
    room.cache.begin_picture();
    CHECK(room.cache.bytes_in_use() == 0);
    CHECK(room.has(1));
    CHECK(room.keep(4)); // where 2 was wanted before
    CHECK(room.has(3));
    CHECK_FALSE(room.has(2));
    CHECK(room.cache.bytes_in_use() == 3 * Room::set_bytes);
    CHECK_FALSE(room.keep(2));
    for (const std::uint32_t number : {1U, 3U, 4U})
        CHECK(room.has(number));
}

TEST_CASE("what comes in beside others replaces none that the picture before has wanted")
{
    Room room{2};
    CHECK(room.keep(1));
    CHECK(room.keep(2));
    room.cache.begin_picture();
    CHECK(room.has(2));
    CHECK_FALSE(keep(room.cache, 3, 3, Incoming::beside_others));
    room.cache.begin_picture();
    CHECK(keep(room.cache, 3, 3, Incoming::beside_others)); // in the place of 1
    CHECK(room.has(2));
    CHECK_FALSE(room.has(1));
}

TEST_CASE("what replaces the next leaves sets of other kinds")
{
    Room room{2};
    CHECK(room.keep(1));
    room.cache.begin({9, 9, 9}, Incoming::beside_others);
    room.cache.add(3);
    CHECK(room.cache.end(true) != nullptr);
    room.cache.begin_picture();
    CHECK(room.keep(2));
    CHECK(room.cache.find({9, 9, 9}) != nullptr);
    CHECK_FALSE(room.keep(3));
}

TEST_CASE("too little room keeps the same sets in all pictures")
{
    Room room{2};
    for (const std::uint32_t number : {1U, 2U, 3U})
        room.keep(number);
    for (int picture = 0; picture < 5; ++picture) {
        room.cache.begin_picture();
        CHECK(room.has(1));
        CHECK(room.has(2));
        CHECK_FALSE(room.has(3));
        CHECK_FALSE(room.keep(3));
    }
}

TEST_CASE("as long as there is room, sets stay, and are of use only in pictures that want them")
{
    Room room{2};
    CHECK(room.keep(1));
    for (int picture = 0; picture < 600; ++picture) {
        room.cache.begin_picture();
        REQUIRE(room.cache.bytes_in_use() == 0);
    }
    CHECK(room.has(1));
}

TEST_CASE("what is too large for the room replaces others once, and not in every picture")
{
    Room room{4};
    int found = 0;
    for (int picture = 0; picture < 10; ++picture) {
        room.cache.begin_picture();
        CHECK_FALSE(is_kept(room.cache, 100, 500));
        CHECK_FALSE(keep(room.cache, 100, 500));
        for (const std::uint32_t number : {1U, 2U, 3U})
            if (room.has(number))
                ++found;
            else
                CHECK(room.keep(number));
    }
    CHECK(found == 9 * 3);
}

TEST_CASE("what is given up although there was room may replace others when it comes again")
{
    Room room{2};
    CHECK(room.keep(1));
    CHECK(room.keep(2));
    room.cache.begin_picture();
    room.cache.begin(name_of(3), Incoming::replaces_next);
    CHECK(room.cache.add(3) != nullptr); // in the place of one of them
    CHECK(room.cache.end(false) == nullptr);
    CHECK(keep(room.cache, 4, 3));
    CHECK(room.keep(3)); // in that of the other
}

TEST_CASE("when the numbers of pictures begin again, sets of the picture before stay")
{
    for (int pictures = 250; pictures < 260; ++pictures) {
        Room room{2};
        CHECK(room.keep(1));
        for (int picture = 0; picture < pictures; ++picture)
            room.cache.begin_picture();
        CHECK(room.keep(2));
        room.cache.begin_picture();
        CHECK(keep(room.cache, 3, 3, Incoming::beside_others)); // in the place of 1, which is older
        CHECK(room.has(2));
        CHECK_FALSE(room.has(1));
    }
}

TEST_CASE("sets of any size come and go without a change to those that stay")
{
    std::mt19937 random{30};
    Room room{20};
    std::map<std::uint32_t, std::size_t> sizes;
    int found = 0;
    for (int picture = 0; picture < 2'000; ++picture) {
        room.cache.begin_picture();
        for (std::uint32_t leaf = 0; leaf < 8; ++leaf) {
            const std::uint32_t number = random() % 16 == 0 ? leaf + 8 : leaf;
            const auto [place, is_new] = sizes.try_emplace(number, random() % 30);
            if (is_kept(room.cache, number, place->second))
                ++found;
            else
                keep(room.cache, number, place->second);
        }
    }
    CHECK(found > 8'000);
}

}
}
