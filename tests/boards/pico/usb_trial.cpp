// An image for tests: whatever report comes over USB goes back, one added to its first byte.

#include "boards/pico/chip/clock.hpp"
#include "boards/pico/chip/clocks.hpp"
#include "boards/pico/chip/watchdog.hpp"
#include "boards/pico/usb/usb_reports.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace kfast::pico {
namespace {

/// Keeps a report until there is room for it on the way back, so that a computer that reads nothing has to
/// wait.
class Echo {
public:
    void serve()
    {
        if (connection_ != usb_reports.connections())
            waiting_.reset();
        connection_ = usb_reports.connections();
        while (has_report() && usb_reports.send(*waiting_))
            waiting_.reset();
    }

private:
    bool has_report()
    {
        if (waiting_)
            return true;
        waiting_ = usb_reports.take();
        if (waiting_)
            waiting_->bytes[0] = static_cast<std::byte>(waiting_->kind() + 1);
        return waiting_.has_value();
    }

    std::optional<Report> waiting_;
    std::uint32_t connection_ = 0;
};

}
}

int main()
{
    using namespace kfast;
    using namespace kfast::pico;
    start_clocks();
    watchdog::start();
    Clock clock;
    clock.begin();
    usb_reports.begin();
    Echo echo;
    while (true) {
        echo.serve();
        clock.doze_until(clock.now() + Microseconds{1000});
    }
}
