#include "firmware/panel/st7789.hpp"

#include "tests/firmware/panel/recorded_bus.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace kfast::test {

TEST_CASE("ST7789: the start-up of the usual glass, byte by byte")
{
    RecordingBus bus;
    DcsPanel{bus, facts_of(Controller::st7789).default_value, st7789}.begin(bus.pause());
    CHECK(bus.lines == std::vector<std::string>{
                           "pause 120000",
                           "command 01",
                           "pause 120000",
                           "command 11",
                           "pause 120000",
                           "command 3A | 55",
                           "command B0 | 00 C0",
                           "command B2 | 0C 0C 00 33 33",
                           "command B7 | 35",
                           "command BB | 19",
                           "command C0 | 2C",
                           "command C2 | 01",
                           "command C3 | 12",
                           "command C4 | 20",
                           "command C6 | 0F",
                           "command D0 | A4 A1",
                           "command E0 | D0 04 0D 11 13 2B 3F 54 4C 18 0D 0B 1F 23",
                           "command E1 | D0 04 0C 11 13 2C 3F 44 51 2F 1F 1F 20 23",
                           "command 13",
                           "command 36 | 00",
                           "command 21",
                           "command 53 | 24",
                           "command 51 | FF",
                       });
}

}
