#include "host/picture/svg_attributes.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

TEST_CASE("lengths are written with no more digits than they need")
{
    CHECK(svg_number(Fixed::pixels(0)) == "0");
    CHECK(svg_number(Fixed::pixels(-32768)) == "-32768");
    CHECK(svg_number(Fixed::sixteenths(1)) == "0.0625");
    CHECK(svg_number(Fixed::sixteenths(-1)) == "-0.0625");
    CHECK(svg_number(Fixed::sixteenths(20)) == "1.25");
    CHECK(svg_number(Fixed::from_raw(65535)) == "1"); // 0.99998
    CHECK(svg_number(Fixed::from_raw(1)) == "0");
    CHECK(svg_number(Fixed::from_raw(-1)) == "0");
    CHECK(svg_number(Fixed::from_raw(-4)) == "-0.0001");
}

TEST_CASE("shares of 255")
{
    CHECK(svg_share(0) == "0");
    CHECK(svg_share(51) == "0.2");
    CHECK(svg_share(128) == "0.502");
    CHECK(svg_share(255) == "1");
}

}
}
