#include "tests/host/synfig/read_file.hpp"

#include <doctest/doctest.h>

using namespace kfast;
using namespace kfast::test;

namespace {

std::string waypoint(const std::string& time, const std::string& value, const std::string& way)
{
    return "<waypoint time=\"" + time + "\" before=\"" + way + "\" after=\"" + way + "\">" + value +
           "</waypoint>";
}

/// The opacity of a circle, which has no units to think about.
art::Channel amount(const std::string& waypoints)
{
    const std::string animated = "<animated type=\"real\">" + waypoints + "</animated>";
    return read_layers(layer("circle", parameter("amount", animated))).node().opacity;
}

}

TEST_CASE("linear waypoints are keys with straight ways")
{
    const art::Channel channel =
        amount(waypoint("0s", real("0.2"), "linear") + waypoint("1s", real("1"), "linear") +
               waypoint("2s", real("0.4"), "linear"));
    REQUIRE(channel.keys.size() == 3);
    CHECK(channel.keys[1].time == 10);
    CHECK(channel.keys[1].value == 1);
    CHECK(channel.keys[0].ease == art::Ease{});
    CHECK(channel.at(5) == doctest::Approx(0.6));
}

TEST_CASE("halting waypoints are keys with the ease of a cubic Hermite curve that begins and ends level")
{
    const art::Channel channel =
        amount(waypoint("0s", real("0"), "halt") + waypoint("2s", real("1"), "halt"));
    REQUIRE(channel.keys.size() == 2);
    CHECK(channel.keys[0].ease.kind == art::EaseKind::cubic);
    CHECK(channel.keys[0].ease.y1 == doctest::Approx(0).epsilon(1e-6));
    CHECK(channel.keys[0].ease.y2 == doctest::Approx(1).epsilon(1e-6));
    CHECK(channel.at(5) == doctest::Approx(0.15625));
}

TEST_CASE("constant waypoints jump at the time of the next one")
{
    const art::Channel channel =
        amount(waypoint("0s", real("0.2"), "constant") + waypoint("1s", real("1"), "constant"));
    CHECK(channel.at(9.9) == doctest::Approx(0.2));
    CHECK(channel.at(10) == doctest::Approx(1));
}

TEST_CASE("automatic waypoints pass a value with the slope between its neighbours")
{
    const art::Channel channel =
        amount(waypoint("0s", real("0"), "auto") + waypoint("1s", real("0.5"), "auto") +
               waypoint("2s", real("0.6"), "auto"));
    // Tangents: 0.5 at first, 0.3 in the middle, 0.1 at last; the value of a Hermite curve at half of the
    // way.
    CHECK(channel.at(5) == doctest::Approx(0.25 + (0.5 - 0.3) / 8).epsilon(0.01));
    CHECK(channel.at(15) == doctest::Approx(0.55 + (0.3 - 0.1) / 8).epsilon(0.01));
}

TEST_CASE("a way that swings and comes back has keys in between")
{
    const art::Channel channel =
        amount(waypoint("0s", real("0.5"), "linear") + waypoint("1s", real("0.1"), "auto") +
               waypoint("2s", real("0.1"), "linear"));
    CHECK(channel.at(10) == doctest::Approx(0.1));
    CHECK(channel.at(14) < 0.09);
    CHECK(channel.at(20) == doctest::Approx(0.1));
}

TEST_CASE("values are worked out from others")
{
    const std::string sine =
        "<sine type=\"real\"><angle><linear type=\"angle\"><slope><angle value=\"90\"/></slope>"
        "<offset><angle value=\"0\"/></offset></linear></angle><amp>" +
        real("1") + "</amp></sine>";
    const art::Channel channel = read_layers(layer("circle", parameter("amount", sine))).node().opacity;
    CHECK(channel.at(10) == doctest::Approx(1).epsilon(0.01));
    CHECK(channel.at(5) == doctest::Approx(0.7071).epsilon(0.01));
}

TEST_CASE("values that are not known are reported")
{
    const ReadFile file = read_layers(layer("circle", parameter("amount", "<crystal type=\"real\"/>")));
    REQUIRE(file.losses.list().size() == 1);
    CHECK(file.losses.list()[0].feature == "value <crystal>");
}
