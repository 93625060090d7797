#include "firmware/start_up.hpp"

#include "tests/bytes.hpp"
#include "tests/firmware/recorded_bus.hpp"

#include <doctest/doctest.h>

#include <array>
#include <vector>

namespace kfast::test {

TEST_CASE("a start-up table is sent row by row, commands with their arguments, and waits where it says so")
{
    constexpr std::array table{
        StartUpStep{.command = 0x01, .wait = {5000}},
        StartUpStep{.command = 0xB8, .argument_count = 8, .arguments = {1, 2, 3, 4, 5, 6, 7, 8}},
        StartUpStep{.command = 0xA0, .argument_count = 1, .arguments = {0x52}},
    };
    RecordedBus bus;
    std::vector<std::size_t> sent_before_wait;
    auto pause = [&](Microseconds time) {
        CHECK(time == Microseconds{5000});
        sent_before_wait.push_back(bus.sent.size());
    };
    send_start_up(bus, table, pause);

    CHECK(bus.sent == std::vector<RecordedBus::Transfer>{
                          {false, bytes({0x01})},
                          {false, bytes({0xB8, 1, 2, 3, 4, 5, 6, 7, 8})},
                          {false, bytes({0xA0, 0x52})},
                      });
    CHECK(sent_before_wait == std::vector<std::size_t>{1});
}

}
