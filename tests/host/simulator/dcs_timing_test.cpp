#include "tests/host/simulator/wired_dcs.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("DCS models: reset and sleep take their time")
{
    WiredModel wired{with_glass(Controller::st7789, {1, 1})};
    SUBCASE("after the power came on")
    {
        CHECK(wired.wait(4.999).low({0x00}).error() ==
              "byte 0 at 4.999 ms: command 0x00 too soon after reset or sleep");
    }
    SUBCASE("5 ms are enough for most") { CHECK(wired.wait(5).low({0x00}).error() == "none"); }
    SUBCASE("but not for sleep out")
    {
        CHECK(wired.wait(119.999).low({0x11}).error() ==
              "byte 0 at 119.999 ms: sleep out too soon: 120 ms pass after reset or sleep in");
    }
    SUBCASE("after the reset line")
    {
        wired.wait(1000).reset();
        SUBCASE("any command")
        {
            CHECK(wired.wait(4).low({0x00}).error() ==
                  "byte 0 at 1004.000 ms: command 0x00 too soon after reset or sleep");
        }
        SUBCASE("sleep out")
        {
            CHECK(wired.wait(119).low({0x11}).error() ==
                  "byte 0 at 1119.000 ms: sleep out too soon: 120 ms pass after reset or sleep in");
        }
    }
    SUBCASE("after a software reset")
    {
        wired.wait(1000).low({0x01});
        SUBCASE("any command")
        {
            CHECK(wired.wait(4).low({0x00}).error() ==
                  "byte 1 at 1004.000 ms: command 0x00 too soon after reset or sleep");
        }
        SUBCASE("sleep out")
        {
            CHECK(wired.wait(119).low({0x11}).error() ==
                  "byte 1 at 1119.000 ms: sleep out too soon: 120 ms pass after reset or sleep in");
        }
    }
    SUBCASE("after sleep out")
    {
        wired.wait(120).low({0x11});
        SUBCASE("any command")
        {
            CHECK(wired.wait(4).low({0x00}).error() ==
                  "byte 1 at 124.000 ms: command 0x00 too soon after reset or sleep");
        }
        SUBCASE("sleep in")
        {
            CHECK(wired.wait(119).low({0x10}).error() ==
                  "byte 1 at 239.000 ms: 0x10 too soon: 120 ms pass after sleep out");
        }
        SUBCASE("software reset")
        {
            CHECK(wired.wait(119).low({0x01}).error() ==
                  "byte 1 at 239.000 ms: 0x01 too soon: 120 ms pass after sleep out");
        }
        SUBCASE("which is heard once")
        {
            CHECK(wired.wait(100).low({0x11}).wait(20).low({0x10}).error() == "none");
        }
    }
    SUBCASE("after sleep in")
    {
        wired.wait(120).low({0x11}).wait(120).low({0x10});
        SUBCASE("any command")
        {
            CHECK(wired.wait(4).low({0x00}).error() ==
                  "byte 2 at 244.000 ms: command 0x00 too soon after reset or sleep");
        }
        SUBCASE("sleep out")
        {
            CHECK(wired.wait(119).low({0x11}).error() ==
                  "byte 2 at 359.000 ms: sleep out too soon: 120 ms pass after reset or sleep in");
        }
        SUBCASE("and all is well after 120 ms") { CHECK(wired.wait(120).low({0x11}).error() == "none"); }
    }
}

TEST_CASE("ST7735 model: hears nothing for 120 ms after reset and sleep out")
{
    WiredModel wired{with_glass(Controller::st7735, {1, 1})};
    SUBCASE("reset")
    {
        CHECK(wired.wait(119).low({0x00}).error() ==
              "byte 0 at 119.000 ms: command 0x00 too soon after reset or sleep");
    }
    SUBCASE("sleep out")
    {
        CHECK(wired.wait(120).low({0x11}).wait(119).low({0x00}).error() ==
              "byte 1 at 239.000 ms: command 0x00 too soon after reset or sleep");
    }
}

}
