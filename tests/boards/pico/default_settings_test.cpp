#include "boards/pico/app/default_settings.hpp"

#include "host/config/config_input.hpp"

#include <doctest/doctest.h>

namespace kfast::pico::test {

TEST_CASE("what an image does without stored settings is one of the ready configurations")
{
    CHECK(default_settings(BusKind::spi) == config::chosen_settings("pico-st7789"));
    CHECK(default_settings(BusKind::i2c) == config::chosen_settings("pico-ssd1306-i2c"));
    CHECK(default_settings(BusKind::parallel_8) == config::chosen_settings("pico-ili9341-parallel"));
    CHECK(default_settings(BusKind::dac) == config::chosen_settings("pico-xy-scope"));
}

}
