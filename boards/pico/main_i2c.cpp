#include "boards/pico/app/app.hpp"
#include "boards/pico/panel/i2c_bus.hpp"
#include "boards/pico/panel/panel_display.hpp"
#include "firmware/settings/image_mark.hpp"

[[gnu::section(".image_mark"), gnu::used]] constexpr kfast::ImageMark mark{kfast::BusKind::i2c};

int main()
{
    using namespace kfast;
    pico::App<pico::PanelDisplay<pico::I2cBus>, mark.bus>{}.run();
}
