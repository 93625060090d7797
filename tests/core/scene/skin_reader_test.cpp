#include "core/scene/skeleton_view.hpp"

#include "tests/core/raw_skin.hpp"
#include "tests/rounds.hpp"

#include <doctest/doctest.h>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

using Shares = std::vector<RawInfluence>;

Shares shares_of(const Binding& binding)
{
    Shares shares;
    binding.each([&shares](BoneInfluence share) {
        shares.push_back({static_cast<int>(share.bone), share.weight});
    });
    CHECK(binding.count() == shares.size());
    return shares;
}

}

TEST_CASE("points of a run have the same bones, and the last bone has the rest of the weights")
{
    const Bytes skin = bytes({0, 8 * 2, 7, 1, 3, 100, 9, 4 + 3, 1, 1, 0, 2, 2, 0, 3, 3, 128, 4, 99});
    SkinReader reader{ByteReader{skin}};
    CHECK_FALSE(reader.has_drawing_at_rest());
    for (int point = 0; point < 3; ++point) {
        CHECK(reader.run_is_over() == (point == 0));
        CHECK(shares_of(reader.next()) == Shares{{7, 65'536}});
    }
    CHECK(reader.run_is_over());
    CHECK(shares_of(reader.next()) == Shares{{3, 25'600}, {9, 39'936}});
    CHECK(shares_of(reader.next()) == Shares{{1, 1}, {2, 2}, {3, 32'771}, {4, 32'762}});
    CHECK(reader.run_is_over());
    CHECK(reader.is_valid());
}

TEST_CASE("one bone may carry all points")
{
    SkinReader reader = SkinReader::of(7);
    CHECK_FALSE(reader.has_drawing_at_rest());
    for (int point = 0; point < 70'000; ++point)
        REQUIRE(shares_of(reader.next()) == Shares{{7, 65'536}});
    CHECK(reader.is_valid());
}

TEST_CASE("a skin may name the drawing at rest, also the first one")
{
    const Bytes first = bytes({1, 0, 0});
    const Bytes later = bytes({0x81, 1, 0, 0});
    CHECK(SkinReader{ByteReader{first}}.has_drawing_at_rest());
    CHECK(SkinReader{ByteReader{first}}.drawing_at_rest() == 0);
    CHECK(SkinReader{ByteReader{later}}.drawing_at_rest() == 128);
}

TEST_CASE("any runs are read back, and weights add up to the whole")
{
    std::mt19937 random{81};
    for (int round = 0; round < rounds(2000); ++round) {
        const unsigned longest = round % 2 == 0 ? 5 : 500;
        std::vector<RawRun> runs(random() % 6);
        for (RawRun& run : runs)
            run = {static_cast<std::uint32_t>(1 + random() % longest), random_shares(random, 255)};
        const Bytes skin = skin_bytes(runs);
        SkinReader reader{ByteReader{skin}};
        for (const RawRun& run : runs)
            for (std::uint32_t point = 0; point < run.points; ++point)
                REQUIRE(shares_of(reader.next()) == run.shares);
        CHECK(reader.run_is_over());
        CHECK(reader.is_valid());
    }
}

TEST_CASE("weights over 255 leave less than 1 for the last bone")
{
    const Bytes skin = bytes({0, 2, 0, 200, 1, 56, 2});
    SkinReader reader{ByteReader{skin}};
    CHECK(shares_of(reader.next())[2].weight == 0);
}

TEST_CASE("a skin that breaks off is noticed")
{
    for (const Bytes& skin : {bytes({0, 1, 3, 100, 9}), bytes({0, 4 + 1, 3, 100, 0, 9})})
        for (std::size_t size = 0; size < skin.size(); ++size) {
            SkinReader reader{ByteReader{std::span{skin}.first(size)}};
            reader.next();
            CHECK_FALSE(reader.is_valid());
        }
}

}
