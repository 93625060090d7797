#include "boards/pico/app/app.hpp"
#include "boards/pico/panel/panel_display.hpp"
#include "boards/pico/panel/parallel_bus.hpp"
#include "firmware/settings/image_mark.hpp"

[[gnu::section(".image_mark"), gnu::used]] constexpr kfast::ImageMark mark{kfast::BusKind::parallel_8};

int main()
{
    using namespace kfast;
    pico::App<pico::PanelDisplay<pico::ParallelBus>, mark.bus>{}.run();
}
