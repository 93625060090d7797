#include "boards/pico/gadget.hpp"
#include "boards/pico/i2c_bus.hpp"

int main()
{
    using namespace kfast;
    pico::Gadget<pico::I2cBus, BusKind::i2c>{}.live();
}
