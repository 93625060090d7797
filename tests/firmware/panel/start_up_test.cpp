#include "firmware/panel/start_up.hpp"

#include "tests/firmware/panel/recorded_bus.hpp"

#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace kfast::test {
namespace {

constexpr std::array table{
    StartUpStep{.command = 0x01, .wait = {5000}},
    StartUpStep{.command = 0xB8, .argument_count = 8, .arguments = {1, 2, 3, 4, 5, 6, 7, 8}},
    StartUpStep{.command = 0xE0,
                .argument_count = 16,
                .arguments = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}},
    StartUpStep{.command = 0xA0, .argument_count = 1, .arguments = {0x52}},
};

}

TEST_CASE("a start-up table is sent row by row, commands with their arguments, and waits where it says so")
{
    RecordingBus bus;
    auto pause = bus.pause();
    send_start_up<Arguments::with_command>(bus, table, pause);

    CHECK(bus.lines == std::vector<std::string>{
                           "command 01",
                           "pause 5000",
                           "command B8 01 02 03 04 05 06 07 08",
                           "command E0 01 02 03 04 05 06 07 08 09 0A 0B 0C 0D 0E 0F 10",
                           "command A0 52",
                       });
}

TEST_CASE("arguments go with D/C high to a controller that wants them so, none where there are none")
{
    RecordingBus bus;
    auto pause = bus.pause();
    send_start_up<Arguments::as_parameters>(bus, table, pause);

    CHECK(bus.lines == std::vector<std::string>{
                           "command 01",
                           "pause 5000",
                           "command B8 | 01 02 03 04 05 06 07 08",
                           "command E0 | 01 02 03 04 05 06 07 08 09 0A 0B 0C 0D 0E 0F 10",
                           "command A0 | 52",
                       });
}

TEST_CASE("of the arguments of a single command the low bytes are sent")
{
    RecordingBus bus;
    send_command<Arguments::as_parameters>(bus, 0x2A, 319 >> 8, 319);
    send_command<Arguments::with_command>(bus, 0x81, std::uint8_t{0xCF});
    send_command<Arguments::with_command>(bus, 0xAE);
    CHECK(bus.lines == std::vector<std::string>{"command 2A | 01 3F", "command 81 CF", "command AE"});
}

}
