#include "boards/pico/gadget.hpp"
#include "boards/pico/panel_display.hpp"
#include "boards/pico/parallel_bus.hpp"
#include "firmware/image_mark.hpp"

[[gnu::section(".image_mark"), gnu::used]] constexpr kfast::ImageMark mark{kfast::BusKind::parallel_8};

int main()
{
    using namespace kfast;
    pico::Gadget<pico::PanelDisplay<pico::ParallelBus>, mark.bus>{}.live();
}
