#include "host/beam/profile_choice.hpp"

#include "host/program/failure.hpp"
#include "tests/temporary_folder.hpp"

#include <doctest/doctest.h>
#include <fstream>

namespace kfast::test {
namespace {

std::string refusal(const std::string& name)
{
    try {
        chosen_profile(name);
    } catch (const Failure& failure) {
        return failure.what();
    }
    return {};
}

bool contains(const std::string& text, std::string_view part) { return text.find(part) != text.npos; }

}

TEST_CASE("a beam is chosen by the name of a profile or of a file")
{
    CHECK(chosen_profile("scope") == scope_profile);
    CHECK(chosen_profile("crt") == crt_profile);
    CHECK(chosen_profile("galvo") == galvo_profile);

    const TemporaryFolder folder;
    std::ofstream{folder / "my.kdl"} << "beam galvo rate=(kHz)20\n";
    CHECK(chosen_profile(folder / "my.kdl").rate == 20'000);
    CHECK(chosen_beam(folder / "my.kdl").base == "galvo");
    CHECK(chosen_beam("crt").base == "crt");
}

TEST_CASE("a beam that there is not is refused with a remedy")
{
    CHECK(contains(refusal("scop"), "there is no beam \"scop\": did you mean \"scope\"?"));
    CHECK(contains(refusal("scop"), "name the file"));
    CHECK(contains(refusal(""), "there is no beam"));

    const TemporaryFolder folder;
    CHECK(contains(refusal(folder / "none.kdl"), "there is no such file"));
    std::ofstream{folder / "bad.kdl"} << "beam galvo rate=20\nbeam scope\n";
    CHECK(contains(refusal(folder / "bad.kdl"), "bad.kdl: 1 error"));
}

}
