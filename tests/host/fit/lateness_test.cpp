#include "host/fit/speed.hpp"

#include "host/fit/wording.hpp"

#include <doctest/doctest.h>
#include <limits>
#include <vector>

namespace kfast::fit {
namespace {

void check_late(const std::vector<double>& seconds, std::size_t late, std::size_t left_out)
{
    const Lateness found = lateness(seconds, 30);
    CHECK(found.frames == seconds.size());
    CHECK(found.late == late);
    CHECK(found.left_out == left_out);
}

}

TEST_CASE("frames are late when the next one is due before they are there")
{
    check_late({}, 0, 0);
    check_late({.01, .02, .01}, 0, 0);
    check_late({1.0 / 30, 1.0 / 30, 1.0 / 30, 1.0 / 30}, 0, 0);
    check_late({.01, .05, .01, .01}, 1, 0);
    check_late({.05, .05, .01, .01}, 3, 0); // the third begins too late as well
    check_late({.01, .01, .5}, 1, 0);
}

TEST_CASE("frames whose time has passed are left out, and count as late")
{
    check_late({.01, .12, .01, .01, .01, .01}, 3, 2);
    check_late({.2, .2, .2, .2, .2, .2}, 6, 4);
    check_late({.01, 1e9, .01}, 2, 1);
}

TEST_CASE("what is late is said with how much of it is left out")
{
    CHECK(late_text({.frames = 76}).empty());
    CHECK(late_text({.frames = 76, .late = 12}) == "12 of 76 pictures late");
    CHECK(late_text({.frames = 76, .late = 12, .left_out = 5}) ==
          "12 of 76 pictures late, 5 of them left out");
}

TEST_CASE("memory, rates and frequencies are said in few digits, and no rate beyond what a panel shows")
{
    CHECK(memory_text(0) == "0 B");
    CHECK(memory_text(1023) == "1023 B");
    CHECK(memory_text(4900) == "4.79 KiB");
    CHECK(memory_text(256 * 1024) == "256 KiB");
    CHECK(memory_text(1023590) == "1000 KiB");
    CHECK(memory_text(1023 * 1024) == "1023 KiB");
    CHECK(memory_text(1536 * 1024) == "1.5 MiB");
    CHECK(rate_text(1000) == "1000 fps");
    CHECK(rate_text(103'220.4) == "more than 1000 fps");
    CHECK(rate_text(std::numeric_limits<double>::infinity()) == "more than 1000 fps");
    CHECK(rate_text(24.48) == "24.4 fps");
    CHECK(frequency_text(1e6) == "1 MHz");
    CHECK(frequency_text(62.5e6) == "62.5 MHz");
    CHECK(frequency_text(999e3) == "999 kHz");
}

TEST_CASE("the firmware has its parts by name, apart from the scene")
{
    Target target;
    target.flash = 2 << 20;
    target.ram = 256 << 10;
    target.reserved = {{.name = "slots", .flash = 1 << 20}, {.ram = 10 << 10}};
    const FlashNeed flash{.player = 50 << 10, .scene = 300 << 10, .reserved = target.reserved_flash()};
    CHECK(firmware_flash_text(flash, target) == "1.05 MiB of 2 MiB of flash: player 50 KiB, slots 1 MiB");
    CHECK(flash.room(target.flash) == (1 << 20) - (50 << 10));
    const RamNeed ram{.block = 5000, .bands = 8 << 10, .stack = 9 << 10, .reserved = target.reserved_ram()};
    CHECK(firmware_ram_text(ram, target, "bands") ==
          "27 KiB of 256 KiB of RAM: bands 8 KiB, stack 9 KiB, reserved 10 KiB");
    CHECK(ram.room(target.ram) == (256 - 27) << 10);
    CHECK(ram.room(0) == 0);
}

}
