#include "core/scene/track_view.hpp"

#include "core/time/spring_law.hpp"
#include "tests/bytes.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("the law for x is in the low bits, that for y in the high ones")
{
    const auto pair = bytes({0x21, 0x34});
    ByteReader reader{pair};
    CHECK(read_law_pair(reader) == LawPair{VelocityLaw::accelerate, VelocityLaw::decelerate});
    CHECK(read_law_pair(reader) == LawPair{VelocityLaw::hold, VelocityLaw::accelerate_decelerate});
    CHECK(reader.left() == 0);
}

TEST_CASE("parameters of x come before those of y")
{
    const auto pair = bytes({0x65, 0x34, 0x12, 0x00, 0x08, 0x00, 0xE0, 0x00, 0x18, 0x00, 0x40, //
                             0x55, 2, 0, 3, 0});
    ByteReader reader{pair};
    CHECK(read_law_pair(reader) ==
          LawPair{VelocityLaw::in_steps(0x1234), VelocityLaw::bezier(2048, -8192, 6144, 16384)});
    CHECK(read_law_pair(reader) == LawPair{VelocityLaw::in_steps(2), VelocityLaw::in_steps(3)});
    CHECK(reader.left() == 0);
    CHECK_FALSE(reader.overrun());
}

TEST_CASE("the law for y may be that for x")
{
    const auto pair = bytes({0xF6, 0x00, 0x08, 0x00, 0xE0, 0x00, 0x18, 0x00, 0x40, 99});
    ByteReader reader{pair};
    constexpr VelocityLaw bezier = VelocityLaw::bezier(2048, -8192, 6144, 16384);
    CHECK(read_law_pair(reader) == LawPair{bezier, bezier});
    CHECK(reader.left() == 1);
}

TEST_CASE("an unknown law has no parameters and is not valid")
{
    const auto pair = bytes({0x09, 1});
    ByteReader reader{pair};
    const LawPair laws = read_law_pair(reader);
    CHECK_FALSE(is_valid(laws.x));
    CHECK(is_valid(laws.y));
    CHECK(reader.left() == 1);
}

TEST_CASE("bounces have one parameter, springs have five")
{
    const auto pair = bytes({0x87, 3, 1, 0, 2, 1, 0, 2, 0, 3, 0, 4, 0});
    ByteReader reader{pair};
    CHECK(read_law_pair(reader) ==
          LawPair{bounce_law(3, SpringEnd::earlier), spring_law({1, 2, 3, 4}, SpringEnd::both)});
    CHECK(reader.left() == 0);
}

TEST_CASE("a pair that breaks off is noticed")
{
    const auto pair = bytes({0x06, 0x00, 0x08, 0x00, 0xE0, 0x00, 0x18, 0x00});
    ByteReader reader{pair};
    read_law_pair(reader);
    CHECK(reader.overrun());
}

}
