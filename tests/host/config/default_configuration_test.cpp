#include "boards/pico/app/default_settings.hpp"
#include "host/config/config_input.hpp"
#include "host/config/configurations.hpp"

#include <doctest/doctest.h>

namespace kfast::test {

TEST_CASE("images without settings take those of a ready configuration")
{
    for (const BusKind bus : {BusKind::spi, BusKind::i2c, BusKind::parallel_8, BusKind::dac}) {
        CAPTURE(config::default_configuration(bus));
        CHECK(config::chosen_settings(config::default_configuration(bus)) == pico::default_settings(bus));
    }
}

}
