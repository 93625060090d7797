#include "host/schema/variables.hpp"

#include "host/kdl/parser.hpp"

#include <doctest/doctest.h>

#include <algorithm>

namespace kfast::test {

using namespace schema;

namespace {

/// The names of those that need themselves, of the properties of a node.
std::string circular(std::string_view definitions)
{
    Diagnostics diagnostics;
    const kdl::Document document = kdl::parse("let " + std::string{definitions}, diagnostics);
    REQUIRE(!diagnostics.has_errors());
    Variables variables;
    for (const kdl::Property& property : document.nodes.front().properties)
        variables.add({.name = property.name, .place = property.name_span, .definition = &property.value});
    std::string names;
    for (const Variable& variable : variables.all())
        names += variables.is_circular(variable) ? variable.name + ' ' : "";
    return names;
}

}

TEST_CASE("a name is given to one variable")
{
    Variables variables;
    CHECK(variables.empty());
    CHECK(variables.add({.name = "a", .place = {3, 1}, .definition = nullptr}) == nullptr);
    CHECK(variables.add({.name = "b", .place = {5, 1}, .definition = nullptr}) == nullptr);
    const Variable* const earlier = variables.add({.name = "a", .place = {9, 1}, .definition = nullptr});
    REQUIRE(earlier != nullptr);
    CHECK(earlier->place.offset == 3);
    CHECK(variables.names() == std::vector<std::string_view>{"a", "b"});
    CHECK(variables.find("b") != nullptr);
    CHECK(variables.find("c") == nullptr);
}

TEST_CASE("what is defined by itself is told from what only needs such a one")
{
    CHECK(circular("a=1 b=a c=a+b") == "");
    CHECK(circular("a=a+1 b=2") == "a ");
    CHECK(circular("a=b b=c c=a d=a") == "a b c ");
    CHECK(circular("a=c b=1 c=b") == "");
    CHECK(circular("a=\"max(1, nothing)\" b=#true") == "");
}

}
