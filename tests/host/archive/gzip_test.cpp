#include "host/archive/archive.hpp"

#include "host/program/failure.hpp"
#include "tests/host/archive/packed.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using archive::gunzipped;
using test::gzipped;

namespace {

constexpr std::size_t room = std::size_t{1} << 20;

}

TEST_CASE("what is packed comes back")
{
    for (const std::string& content : {std::string{}, std::string{"<svg/>"}, std::string(300'000, 'x')}) {
        const std::string packed = gzipped(content);
        CHECK(archive::is_gzip(packed));
        CHECK(gunzipped("a.svgz", packed, room) == content);
    }
    CHECK_FALSE(archive::is_gzip("<svg/>"));
    CHECK_FALSE(archive::is_gzip(""));
}

TEST_CASE("members follow each other, and padding does not matter")
{
    CHECK(gunzipped("a", gzipped("one ") + gzipped("two"), room) == "one two");
    CHECK(gunzipped("a", gzipped("one") + std::string(512, '\0'), room) == "one");
}

TEST_CASE("what holds more than is allowed is refused, whatever it says of its size")
{
    const std::string bomb = gzipped(std::string(room + 1, '\0'));
    CHECK(bomb.size() < 2000);
    CHECK_THROWS_WITH_AS(gunzipped("a.svgz", bomb, room),
                         "a.svgz: holds more than 1 MB: is it the right file?", Failure);
    CHECK(gunzipped("a.svgz", gzipped(std::string(room, '\0')), room).size() == room);
    std::string many;
    for (int member = 0; member < 40; ++member)
        many += gzipped(std::string(room / 32, 'x'));
    CHECK_THROWS_AS(gunzipped("a.svgz", many, room), Failure);
}

TEST_CASE("what breaks off or is damaged is refused")
{
    std::string packed = gzipped("<svg xmlns=\"http://www.w3.org/2000/svg\"/>");
    for (std::size_t size = 2; size < packed.size(); ++size)
        CHECK_THROWS_WITH_AS(gunzipped("a.svgz", packed.substr(0, size), room),
                             "a.svgz: breaks off before its end: copy it again", Failure);
    packed[packed.size() - 6] ^= 1; // of the checksum
    CHECK_THROWS_WITH_AS(gunzipped("a.svgz", packed, room),
                         "a.svgz: the packed file is damaged: copy it again", Failure);
}
