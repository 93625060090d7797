#include "firmware/panel/st7735.hpp"

#include "tests/firmware/panel/recorded_bus.hpp"

#include <doctest/doctest.h>

#include <string>
#include <vector>

namespace kfast::test {

TEST_CASE("ST7735: the start-up of the usual glass, byte by byte")
{
    RecordingBus bus;
    DcsPanel{bus, facts_of(Controller::st7735).default_value, st7735}.begin(bus.pause());
    CHECK(bus.lines == std::vector<std::string>{
                           "pause 120000",
                           "command 01",
                           "pause 120000",
                           "command 11",
                           "pause 120000",
                           "command B1 | 01 2C 2D",
                           "command B2 | 01 2C 2D",
                           "command B3 | 01 2C 2D 01 2C 2D",
                           "command B4 | 07",
                           "command C0 | A2 02 84",
                           "command C1 | C5",
                           "command C2 | 0A 00",
                           "command C3 | 8A 2A",
                           "command C4 | 8A EE",
                           "command C5 | 0E",
                           "command 3A | 05",
                           "command E0 | 02 1C 07 12 37 32 29 2D 29 25 2B 39 00 01 03 10",
                           "command E1 | 03 1D 07 06 2E 2C 29 2D 2E 2E 37 3F 00 00 02 10",
                           "command 13",
                           "command 36 | 08",
                           "command 20",
                       });
}

}
