#include "firmware/panel/gc9a01.hpp"

#include "tests/firmware/panel/recorded_bus.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace kfast::test {

TEST_CASE("GC9A01: the start-up of the usual glass, byte by byte")
{
    RecordingBus bus;
    DcsPanel{bus, facts_of(Controller::gc9a01).default_value, gc9a01}.begin(bus.pause());
    CHECK(bus.lines == std::vector<std::string>{
                           "pause 120000",
                           "command 01",
                           "pause 120000",
                           "command EF",
                           "command EB | 14",
                           "command FE",
                           "command EF",
                           "command EB | 14",
                           "command 84 | 40",
                           "command 85 | FF",
                           "command 86 | FF",
                           "command 87 | FF",
                           "command 88 | 0A",
                           "command 89 | 21",
                           "command 8A | 00",
                           "command 8B | 80",
                           "command 8C | 01",
                           "command 8D | 01",
                           "command 8E | FF",
                           "command 8F | FF",
                           "command B6 | 00 20",
                           "command 3A | 05",
                           "command 90 | 08 08 08 08",
                           "command BD | 06",
                           "command BC | 00",
                           "command FF | 60 01 04",
                           "command C3 | 13",
                           "command C4 | 13",
                           "command C9 | 22",
                           "command BE | 11",
                           "command E1 | 10 0E",
                           "command DF | 21 0C 02",
                           "command F0 | 45 09 08 08 26 2A",
                           "command F1 | 43 70 72 36 37 6F",
                           "command F2 | 45 09 08 08 26 2A",
                           "command F3 | 43 70 72 36 37 6F",
                           "command ED | 1B 0B",
                           "command AE | 77",
                           "command CD | 63",
                           "command 70 | 07 07 04 0E 0F 09 07 08 03",
                           "command E8 | 34",
                           "command 62 | 18 0D 71 ED 70 70 18 0F 71 EF 70 70",
                           "command 63 | 18 11 71 F1 70 70 18 13 71 F3 70 70",
                           "command 64 | 28 29 F1 01 F1 00 07",
                           "command 66 | 3C 00 CD 67 45 45 10 00 00 00",
                           "command 67 | 00 3C 00 00 00 01 54 10 32 98",
                           "command 74 | 10 85 80 00 00 4E 00",
                           "command 98 | 3E 07",
                           "command 11",
                           "pause 120000",
                           "command 36 | 08",
                           "command 21",
                           "command 53 | 24",
                           "command 51 | FF",
                       });
}

}
