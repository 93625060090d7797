#include "boards/pico/app/app.hpp"
#include "boards/pico/panel/panel_display.hpp"
#include "boards/pico/panel/spi_bus.hpp"
#include "firmware/settings/image_mark.hpp"

[[gnu::section(".image_mark"), gnu::used]] constexpr kfast::ImageMark mark{kfast::BusKind::spi};

int main()
{
    using namespace kfast;
    pico::App<pico::PanelDisplay<pico::SpiBus>, mark.bus>{}.run();
}
