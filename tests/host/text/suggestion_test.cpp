#include "host/text/suggestion.hpp"

#include <doctest/doctest.h>

#include <array>
#include <vector>

namespace kfast::test {
namespace {

constexpr std::array<std::string_view, 4> known{"circle", "rect", "line", "key"};

}

TEST_CASE("a name is suggested when a third of the letters or less is wrong")
{
    CHECK(suggestion("cirle", known) == "did you mean \"circle\"?");
    CHECK(suggestion("cricle", known) == "did you mean \"circle\"?");
    CHECK(suggestion("circles", known) == "did you mean \"circle\"?");
    CHECK(suggestion("rekt", known) == "did you mean \"rect\"?");
    CHECK(suggestion("kye", known) == "did you mean \"key\"?");
    CHECK(suggestion("disc", known) == "allowed: circle, rect, line, key");
    CHECK(suggestion("x", known) == "allowed: circle, rect, line, key");
    CHECK(suggestion("-f", std::array<std::string_view, 2>{"-h", "-o"}) == "allowed: -h, -o");
    CHECK(suggestion("--ab", std::array<std::string_view, 1>{"--a"}) == "did you mean \"--a\"?");
    CHECK(suggestion("", known) == "allowed: circle, rect, line, key");
}

TEST_CASE("the closest name wins, the first of equals")
{
    CHECK(suggestion("law-xx", std::array<std::string_view, 3>{"law-y", "law-x", "law"}) ==
          "did you mean \"law-x\"?");
    CHECK(suggestion("law-z", std::array<std::string_view, 3>{"law-x", "law-y", "law"}) ==
          "did you mean \"law-x\"?");
}

TEST_CASE("long names and long lists stay cheap and short")
{
    CHECK(suggestion(std::string(1'000'000, 'a'), known) == "allowed: circle, rect, line, key");
    const std::vector<std::string_view> many(50, "name");
    const std::string list = suggestion("other-thing", many);
    CHECK(list.ends_with("name, …"));
    CHECK(list.size() < 260);
    CHECK(suggestion("x", {}) == "nothing is allowed here");
}

}
