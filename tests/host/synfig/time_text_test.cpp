#include "host/synfig/values/constant_reader.hpp"

#include <doctest/doctest.h>

using namespace kfast::synfig;

TEST_CASE("times are sums of hours, minutes, seconds and frames")
{
    CHECK(time_of("1s 12f", 24) == 1.5);
    CHECK(time_of("1h 2m 3.5s", 24) == 3723.5);
    CHECK(time_of("-6f", 24) == -0.25);
    CHECK(time_of("12", 24) == 0.5);
    CHECK(time_of("SOT", 24) == begin_of_time);
    CHECK(time_of("EOT", 24) == end_of_time);
}

TEST_CASE("what is no time is none")
{
    CHECK_FALSE(time_of("", 24));
    CHECK_FALSE(time_of("soon", 24));
    CHECK_FALSE(time_of("3x", 24));
    CHECK_FALSE(time_of("1e999s", 24));
}
