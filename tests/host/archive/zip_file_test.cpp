#include "host/archive/archive.hpp"

#include "host/program/failure.hpp"
#include "tests/host/archive/packed.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using archive::ZipFile;
using test::zipped;

namespace {

constexpr std::size_t room = std::size_t{1} << 20;

}

TEST_CASE("members are read by their paths")
{
    const std::string packed = zipped({{"manifest.json", "{}"}, {"a/one.json", std::string(5000, ' ')}});
    REQUIRE(archive::is_zip(packed));
    const ZipFile file{"x.lottie", packed};
    CHECK(file.members() == std::vector<std::string>{"manifest.json", "a/one.json"});
    CHECK(file.has("a/one.json"));
    CHECK_FALSE(file.has("one.json"));
    CHECK(file.content("manifest.json", room) == "{}");
    CHECK(file.content("a/one.json", room) == std::string(5000, ' '));
    CHECK_THROWS_WITH_AS(file.content("b", room),
                         "x.lottie: b is not in it: copy the file again, or pack it again", Failure);
}

TEST_CASE("an empty zip file has no members")
{
    const std::string empty = std::string{"PK\x05\x06"} + std::string(18, '\0');
    REQUIRE(archive::is_zip(empty));
    CHECK(ZipFile("x.lottie", empty).members().empty());
    CHECK_FALSE(archive::is_zip("PK"));
}

TEST_CASE("what is larger than allowed is refused, and what just fits is not")
{
    const std::string packed = zipped({{"a", std::string(room + 1, '\0')}, {"b", std::string(room, '\0')}});
    CHECK(packed.size() < 5000);
    const ZipFile file{"x.lottie", packed};
    CHECK_THROWS_WITH_AS(file.content("a", room), "x.lottie: a is larger than 1 MB: is it the right file?",
                         Failure);
    CHECK(file.content("b", room).size() == room);
}

TEST_CASE("a crowd of members is refused")
{
    test::Files files;
    for (std::size_t number = 0; number <= ZipFile::max_members; ++number)
        files.emplace_back(std::to_string(number), "");
    const std::string packed = zipped(files);
    CHECK_THROWS_WITH_AS(ZipFile("x.lottie", packed),
                         "x.lottie: holds more than 4096 files: is it the right file?", Failure);
}

TEST_CASE("what is encrypted is refused with the remedy")
{
    const std::string packed = zipped({{"a", "secret"}}, "password");
    const ZipFile file{"x.lottie", packed};
    CHECK_THROWS_WITH_AS(file.content("a", room),
                         "x.lottie: a is encrypted: unpack it, and pack it without a password", Failure);
}

TEST_CASE("a file that breaks off is refused, and a damaged one gives nothing else than it held")
{
    const std::string packed = zipped({{"a", "hello hello hello hello"}});
    for (std::size_t size = 4; size < packed.size(); ++size)
        CHECK_THROWS_AS(ZipFile("x.lottie", std::string_view{packed}.substr(0, size)), Failure);
    for (std::size_t at = 0; at < packed.size(); ++at) {
        std::string damaged = packed;
        damaged[at] ^= 0x10;
        try {
            const ZipFile file{"x.lottie", damaged};
            const std::string content = file.content(file.members().at(0), room);
            CHECK(content == "hello hello hello hello");
        } catch (const Failure&) {
        }
    }
}
