#include "firmware/panel/panel_choice.hpp"

#include "tests/firmware/panel/recorded_bus.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace kfast::test {
namespace {

/// What is used, and how often.
struct Used {
    std::vector<std::string> started; ///< the first lines of the start-up
    Size size;
    PixelFormat format{};
    int window_bytes = 0;
    bool follows_dcs = false;
    int times = 0;
};

Used used(const PanelSettings& settings)
{
    RecordingBus bus;
    Used result;
    with_panel(bus, settings, [&](auto& panel) {
        using Driver = std::remove_reference_t<decltype(panel)>;
        static_assert(PoweredPanel<Driver>);
        panel.begin(bus.pause());
        result.started = bus.lines;
        result.size = panel.size();
        result.format = Driver::format;
        result.window_bytes = Driver::window_bytes;
        result.follows_dcs = std::is_same_v<Driver, DcsPanel<RecordingBus>>;
        ++result.times;
    });
    return result;
}

/// Whether the controller's start-up has this line, which no other's has.
bool sends_alone(Controller controller, std::string_view line)
{
    bool found = false;
    for (const ControllerFacts& facts : controller_facts) {
        const auto lines = used(facts.default_value).started;
        const bool has = std::ranges::find(lines, line) != lines.end();
        if (has && facts.default_value.controller != controller)
            return false;
        found = found || has;
    }
    return found;
}

}

TEST_CASE("every controller is driven by its own start-up")
{
    CHECK(sends_alone(Controller::st7789, "command D0 | A4 A1"));
    CHECK(sends_alone(Controller::ili9341, "command EF | 03 80 02"));
    CHECK(sends_alone(Controller::st7735, "command B4 | 07"));
    CHECK(sends_alone(Controller::gc9a01, "command EB | 14"));
    CHECK(sends_alone(Controller::ssd1306, "command 8D 14"));
    CHECK(sends_alone(Controller::ssd1351, "command FD | 12"));
    CHECK(sends_alone(Controller::ssd0323, "command A0 52"));
}

TEST_CASE("every driver is used once, and is what is known of its controller")
{
    for (const ControllerFacts& facts : controller_facts) {
        CAPTURE(controller_names[static_cast<std::size_t>(facts.default_value.controller)]);
        const Used it = used(facts.default_value);
        CHECK(it.times == 1);
        CHECK(it.size == facts.default_value.glass);
        CHECK(it.window_bytes == facts.window_bytes);
        CHECK(it.format == (facts.format == PixelFormat::rgb565 ? PixelFormat::rgb565_be : facts.format));
    }
}

TEST_CASE("the controllers that follow MIPI DCS share one driver")
{
    int followers = 0;
    for (const ControllerFacts& facts : controller_facts)
        followers += used(facts.default_value).follows_dcs ? 1 : 0;
    CHECK(followers == 4);
}

}
