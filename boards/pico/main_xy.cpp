#include "boards/pico/app/app.hpp"
#include "boards/pico/beam/beam_display.hpp"
#include "firmware/settings/image_mark.hpp"

[[gnu::section(".image_mark"), gnu::used]] constexpr kfast::ImageMark mark{kfast::BusKind::dac};

int main()
{
    using namespace kfast;
    pico::App<pico::BeamDisplay, mark.bus>{}.run();
}
