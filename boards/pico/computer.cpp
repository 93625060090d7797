#include "boards/pico/computer.hpp"

#include "boards/pico/usb_reports.hpp"

namespace kfast::pico {

void Computer::serve()
{
    while (usb_reports.take())
        ++dropped_;
}

void Computer::serve_until(Microseconds moment, const Clock& clock)
{
    serve();
    while (!reached(clock.now(), moment)) {
        clock.doze_until(moment);
        serve();
    }
}

}
