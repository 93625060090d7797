#include "boards/pico/gadget.hpp"
#include "boards/pico/panel_display.hpp"
#include "boards/pico/spi_bus.hpp"
#include "firmware/image_mark.hpp"

[[gnu::section(".image_mark"), gnu::used]] constexpr kfast::ImageMark mark{kfast::BusKind::spi};

int main()
{
    using namespace kfast;
    pico::Gadget<pico::PanelDisplay<pico::SpiBus>, mark.bus>{}.live();
}
