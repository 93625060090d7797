#include "boards/pico/gadget.hpp"
#include "boards/pico/parallel_bus.hpp"

int main()
{
    using namespace kfast;
    pico::Gadget<pico::ParallelBus, BusKind::parallel_8>{}.live();
}
