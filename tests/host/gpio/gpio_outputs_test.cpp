#include "host/gpio/gpio_outputs.hpp"

#include "host/program/failure.hpp"
#include "tests/host/gpio/gpio_bench.hpp"

#include <array>
#include <doctest/doctest.h>
#include <optional>

namespace kfast::test {
namespace {

using Happened = std::vector<std::string>;

constexpr const char* header = "label pinctrl-test\nlines 28\nnamed 4 GPIO4\nnamed 25 GPIO25\nnamed 26 7\n";
constexpr const char* expander = "label expander\nlines 8\nnamed 2 LEDS\n";

const std::array two{GpioLine{"GPIO25", true}, GpioLine{"4"}};

struct Refusal {
    std::string text;
    ExitStatus status = ExitStatus::done;
};

Refusal refusal_of(const std::string& chip, std::span<const GpioLine> lines,
                   GpioDrive drive = GpioDrive::push_pull)
{
    try {
        const GpioOutputs outputs{chip, lines, drive};
    } catch (const Failure& failure) {
        return {failure.what(), failure.status()};
    }
    return {};
}

bool says(const Refusal& refusal, const std::string& text)
{
    INFO(refusal.text);
    const bool found = refusal.text.find(text) != std::string::npos;
    CHECK(found);
    return found;
}

}

TEST_CASE("lines are taken at their levels, set, and given back")
{
    GpioBench bench;
    bench.add_chip("gpiochip0", header);
    {
        GpioOutputs outputs{"/dev/gpiochip0", two};
        CHECK(bench.happened() == Happened{"take gpiochip0 25 push-pull", "line gpiochip0 25 1",
                                           "take gpiochip0 4 push-pull", "line gpiochip0 4 0"});
        outputs.set(0b11, 0b10);
        CHECK(bench.happened() == Happened{"line gpiochip0 25 0", "line gpiochip0 4 1"});
        outputs.set(0b01, 0b01);
        CHECK(bench.happened() == Happened{"line gpiochip0 25 1"});
        outputs.set(0b10, 0b00);
        CHECK(bench.happened() == Happened{"line gpiochip0 4 0"});
    }
    CHECK(bench.happened() == Happened{"free gpiochip0 25", "free gpiochip0 4"});
}

TEST_CASE("as many lines as there may be are set at once")
{
    GpioBench bench;
    bench.add_chip("gpiochip0", "label wide\nlines 40\n");
    std::vector<GpioLine> lines;
    for (std::size_t i = 0; i < GpioOutputs::max_lines; ++i)
        lines.push_back({std::to_string(i + 8), i % 2 == 0});
    GpioOutputs outputs{"", lines};
    bench.happened();
    outputs.set(0xFFFF'FFFF, 0xAAAA'AAAA);
    const Happened happened = bench.happened();
    REQUIRE(happened.size() == GpioOutputs::max_lines);
    CHECK(happened.front() == "line gpiochip0 8 0");
    CHECK(happened.back() == "line gpiochip0 39 1");
}

TEST_CASE("lines that are moved stay taken")
{
    GpioBench bench;
    bench.add_chip("gpiochip0", header);
    std::optional<GpioOutputs> first{GpioOutputs{"", two}};
    GpioOutputs second = std::move(*first);
    first.reset();
    bench.happened();
    second.set(0b10, 0b10);
    CHECK(bench.happened() == Happened{"line gpiochip0 4 1"});
}

TEST_CASE("open drain")
{
    GpioBench bench;
    bench.add_chip("gpiochip0", header);
    const GpioOutputs outputs{"gpiochip0", two, GpioDrive::open_drain};
    CHECK(bench.happened().front() == "take gpiochip0 25 open-drain");
}

TEST_CASE("a chip is named by its path, its name, or its label")
{
    GpioBench bench;
    bench.add_chip("gpiochip0", header);
    bench.add_chip("gpiochip10", expander);
    bench.add_link("gpiochip4", "gpiochip10"); // as a Raspberry Pi 5 has it, for old programs
    for (const char* const chip : {"/dev/gpiochip10", "gpiochip10", "expander", "/dev/gpiochip4"}) {
        CAPTURE(chip);
        bench.happened();
        const GpioOutputs outputs{chip, std::array{GpioLine{"LEDS"}}};
        CHECK(bench.happened().front() == "take gpiochip10 2 push-pull");
    }
}

TEST_CASE("without a chip, the first that has a line of that name, or the only one")
{
    GpioBench bench;
    bench.add_chip("gpiochip10", header);
    {
        const GpioOutputs outputs{"", std::array{GpioLine{"3"}}};
        CHECK(bench.happened().front() == "take gpiochip10 3 push-pull");
    }
    bench.add_chip("gpiochip2", expander);
    bench.happened();
    {
        const GpioOutputs outputs{"", two};
        CHECK(bench.happened().front() == "take gpiochip10 25 push-pull");
    }
    bench.add_chip("gpiochip9", header);
    bench.happened();
    const GpioOutputs outputs{"", two};
    CHECK(bench.happened().front() == "take gpiochip9 25 push-pull");
}

TEST_CASE("a number is a line's place, and its name only if there is no such place")
{
    GpioBench bench;
    bench.add_chip("gpiochip0", "label test\nlines 8\nnamed 2 7\nnamed 3 99\n");
    const GpioOutputs outputs{"", std::array{GpioLine{"7"}, GpioLine{"99"}}};
    const Happened happened = bench.happened();
    CHECK(happened[0] == "take gpiochip0 7 push-pull");
    CHECK(happened[2] == "take gpiochip0 3 push-pull");
}

TEST_CASE("a chip that is not there")
{
    GpioBench bench;
    Refusal refusal = refusal_of("", two);
    CHECK(refusal.status == ExitStatus::no_device);
    says(refusal, "no GPIO chip");

    bench.add_chip("gpiochip0", header);
    for (const char* const chip : {"gpiochip1", "/dev/gpiochip1", "/dev/null", "pinctrl-other"}) {
        CAPTURE(chip);
        CHECK(refusal_of(chip, two).status == ExitStatus::no_device);
    }
    says(refusal_of("/dev/gpiochip1", two), "/dev/gpiochip1 is no GPIO chip");
    says(refusal_of("pinctrl-other", two), "there are gpiochip0 (pinctrl-test)");
}

TEST_CASE("a chip that could be several")
{
    GpioBench bench;
    bench.add_chip("gpiochip0", header);
    bench.add_chip("gpiochip1", header);
    const Refusal by_number = refusal_of("", std::array{GpioLine{"3"}});
    CHECK(by_number.status == ExitStatus::wrong_usage);
    says(by_number, "there are gpiochip0 (pinctrl-test), gpiochip1 (pinctrl-test)");
    const Refusal by_label = refusal_of("pinctrl-test", two);
    CHECK(by_label.status == ExitStatus::wrong_usage);
    says(by_label, "/dev/gpiochip0");
}

TEST_CASE("a line that is not there")
{
    GpioBench bench;
    bench.add_chip("gpiochip0", header);
    const Refusal nowhere = refusal_of("", std::array{GpioLine{"GPIO99"}});
    CHECK(nowhere.status == ExitStatus::no_device);
    says(nowhere, "'gpioinfo' lists them");
    for (const char* const line : {"28", "GPIO99", "-1", "4x", "99999999999", ""}) {
        CAPTURE(line);
        const Refusal refusal = refusal_of("gpiochip0", std::array{GpioLine{"4"}, GpioLine{line}});
        CHECK(refusal.status == ExitStatus::no_device);
        says(refusal, "gpiochip0 (pinctrl-test) has no line '" + std::string{line} + "'");
    }
}

TEST_CASE("a line for two things")
{
    GpioBench bench;
    bench.add_chip("gpiochip0", header);
    const Refusal refusal = refusal_of("", std::array{GpioLine{"GPIO25"}, GpioLine{"25"}});
    CHECK(refusal.status == ExitStatus::wrong_usage);
    says(refusal, "line '25' of gpiochip0 (pinctrl-test) is asked for twice");
}

TEST_CASE("a line that somebody has")
{
    GpioBench bench;
    bench.add_chip("gpiochip0", std::string{header} + "taken 4 spi0 CS1\n");
    const Refusal by_driver = refusal_of("", two);
    CHECK(by_driver.status == ExitStatus::refused);
    says(by_driver, "line 4 by 'spi0 CS1'");
    says(by_driver, "gpioinfo gpiochip0");
    CHECK(bench.happened().empty());

    const std::array other{GpioLine{"9"}};
    const GpioOutputs outputs{"", other};
    says(refusal_of("", other), "line 9 by 'kfast'");
}

TEST_CASE("what may not be opened")
{
    GpioBench bench;
    bench.add_chip("gpiochip0", "error 13\n");
    for (const char* const chip : {"", "gpiochip0", "pinctrl-test"}) {
        CAPTURE(chip);
        const Refusal refusal = refusal_of(chip, two);
        CHECK(refusal.status == ExitStatus::no_permission);
        says(refusal, "usermod -aG gpio");
    }
    bench.add_chip("gpiochip1", header);
    CHECK(refusal_of("", two).status == ExitStatus::done);
}

TEST_CASE("a chip that cannot do open drain")
{
    GpioBench bench;
    bench.add_chip("gpiochip0", std::string{header} + "push-pull-only\n");
    const Refusal refusal = refusal_of("", two, GpioDrive::open_drain);
    CHECK(refusal.status == ExitStatus::refused);
    says(refusal, "open-drain");
}

TEST_CASE("a chip that goes away while its lines are asked for")
{
    GpioBench bench;
    bench.add_chip("gpiochip0", std::string{header} + "vanishes-at 4\n");
    const Refusal refusal = refusal_of("gpiochip0", std::array{GpioLine{"3"}, GpioLine{"4"}});
    CHECK(refusal.status == ExitStatus::unplugged);
    says(refusal, "gpiochip0 (pinctrl-test) is gone");
    CHECK(bench.happened().empty());
}

TEST_CASE("a chip that goes away")
{
    GpioBench bench;
    bench.add_chip("gpiochip0", std::string{header} + "gone-after 1\n");
    GpioOutputs outputs{"", two};
    outputs.set(1, 0);
    try {
        outputs.set(1, 1);
        FAIL("it was set");
    } catch (const Failure& failure) {
        CHECK(failure.status() == ExitStatus::unplugged);
        CHECK(std::string{failure.what()}.find("gpiochip0 (pinctrl-test)") == 0);
    }
}

}
