#include "host/commands/text/quantity_text.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("times are read in seconds, milliseconds and frames")
{
    CHECK(read_time("1.5s", 30000) == Time::frame(45));
    CHECK(read_time("500ms", 30000) == Time::frame(15));
    CHECK(read_time("12.5", 30000) == Time{12 * 1024 + 512});
    CHECK(read_time("0", 30000) == Time{0});
    CHECK(read_time("1s", 23976) == Time{24551}); // 23.976 x 1024 = 24551.4
}

TEST_CASE("a time is rounded to the nearest tick")
{
    CHECK(read_time("0.0004", 30000) == Time{0});
    CHECK(read_time("0.0006", 30000) == Time{1});
}

TEST_CASE("the largest time fits, the next does not")
{
    CHECK(read_time("2097151.999", 30000) == Time{2147483647});
    CHECK_FALSE(read_time("2097152", 30000).has_value());
    CHECK_FALSE(read_time("99999999999999999999s", 30000).has_value());
}

TEST_CASE("what is no time is refused")
{
    for (const char* text :
         {"", "s", "1 s", "1m", "-1", "-0.5s", "1e3", "inf", "nan", "0x10", "1.5s ", "1,5"})
        CHECK_FALSE(read_time(text, 30000).has_value());
}

}
