#include "host/gpio/boot_entry.hpp"

#include "host/program/failure.hpp"
#include "tests/host/gpio/gpio_bench.hpp"

#include <csignal>
#include <doctest/doctest.h>
#include <map>

namespace kfast::test {
namespace {

using Happened = std::vector<std::string>;

constexpr const char* chip = "label pinctrl-test\nlines 8\nnamed 3 GPIO3\n";

const Happened whole{
    "take gpiochip0 3 open-drain",
    "line gpiochip0 3 1",
    "take gpiochip0 5 open-drain",
    "line gpiochip0 5 1",
    "line gpiochip0 5 0",
    "slept",
    "line gpiochip0 3 0",
    "slept",
    "line gpiochip0 3 1",
    "slept",
    "line gpiochip0 5 1",
    "free gpiochip0 3",
    "free gpiochip0 5",
};

}

TEST_CASE("BOOTSEL is held while RUN rises, and both are let go")
{
    GpioBench bench;
    bench.add_chip("gpiochip0", chip);
    enter_boot_loader({.chip = "", .reset = "GPIO3", .boot = "5"});
    CHECK(bench.happened() == whole);
}

TEST_CASE("a signal that is remembered does not leave the chip in reset")
{
    GpioBench bench;
    bench.add_chip("gpiochip0", chip);
    const auto before = std::signal(SIGINT, [](int) {});
    bench.send_signal(SIGINT, 2);
    enter_boot_loader({.chip = "", .reset = "GPIO3", .boot = "5"});
    std::signal(SIGINT, before);
    Happened happened = bench.happened();
    CHECK(std::erase(happened, "signal 2") == 1);
    CHECK(happened == whole);
}

TEST_CASE("a failure does not leave the chip in reset")
{
    for (const int call : {1, 2, 3, 4}) {
        CAPTURE(call);
        GpioBench bench;
        bench.add_chip("gpiochip0", std::string{chip} + "fails-at " + std::to_string(call) + '\n');
        CHECK_THROWS_AS(enter_boot_loader({.chip = "", .reset = "GPIO3", .boot = "5"}), Failure);
        std::map<std::string, std::string> levels;
        for (const std::string& what : bench.happened())
            if (what.starts_with("line "))
                levels[what.substr(0, what.size() - 1)] = what.back();
        CHECK(levels ==
              std::map<std::string, std::string>{{"line gpiochip0 3 ", "1"}, {"line gpiochip0 5 ", "1"}});
    }
}

TEST_CASE("a chip that goes away is told")
{
    for (const int calls : {0, 1, 2, 3}) {
        CAPTURE(calls);
        GpioBench bench;
        bench.add_chip("gpiochip0", std::string{chip} + "gone-after " + std::to_string(calls) + '\n');
        CHECK_THROWS_AS(enter_boot_loader({.chip = "", .reset = "GPIO3", .boot = "5"}), Failure);
        CHECK(bench.happened().back() == "free gpiochip0 5");
    }
}

TEST_CASE("lines that cannot be had are not touched")
{
    GpioBench bench;
    bench.add_chip("gpiochip0", std::string{chip} + "taken 5 button\n");
    CHECK_THROWS_AS(enter_boot_loader({.chip = "", .reset = "GPIO3", .boot = "5"}), Failure);
    CHECK(bench.happened().empty());
}

}
