#include "boards/pico/gadget.hpp"
#include "boards/pico/spi_bus.hpp"

int main()
{
    using namespace kfast;
    pico::Gadget<pico::SpiBus, BusKind::spi>{}.live();
}
