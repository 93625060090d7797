#include "boards/pico/gadget.hpp"
#include "boards/pico/i2c_bus.hpp"
#include "boards/pico/panel_display.hpp"
#include "firmware/image_mark.hpp"

[[gnu::section(".image_mark"), gnu::used]] constexpr kfast::ImageMark mark{kfast::BusKind::i2c};

int main()
{
    using namespace kfast;
    pico::Gadget<pico::PanelDisplay<pico::I2cBus>, mark.bus>{}.live();
}
