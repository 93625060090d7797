#include "firmware/panel/ili9341.hpp"

#include "tests/firmware/panel/recorded_bus.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace kfast::test {

TEST_CASE("ILI9341: the start-up of the usual glass, byte by byte")
{
    RecordingBus bus;
    DcsPanel{bus, facts_of(Controller::ili9341).default_value, ili9341}.begin(bus.pause());
    CHECK(bus.lines == std::vector<std::string>{
                           "pause 120000",
                           "command 01",
                           "pause 120000",
                           "command EF | 03 80 02",
                           "command CF | 00 C1 30",
                           "command ED | 64 03 12 81",
                           "command E8 | 85 00 78",
                           "command CB | 39 2C 00 34 02",
                           "command F7 | 20",
                           "command EA | 00 00",
                           "command C0 | 23",
                           "command C1 | 10",
                           "command C5 | 3E 28",
                           "command C7 | 86",
                           "command 3A | 55",
                           "command B1 | 00 1B",
                           "command B6 | 08 A2 27",
                           "command F2 | 00",
                           "command 26 | 01",
                           "command E0 | 0F 31 2B 0C 0E 08 4E F1 37 07 10 03 0E 09 00",
                           "command E1 | 00 0E 14 03 11 07 31 C1 48 08 0F 0C 31 36 0F",
                           "command 11",
                           "pause 120000",
                           "command 36 | 08",
                           "command 20",
                           "command 53 | 24",
                           "command 51 | FF",
                       });
}

}
