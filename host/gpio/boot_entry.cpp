#include "host/gpio/boot_entry.hpp"

#include "host/gpio/gpio_outputs.hpp"

#include <array>
#include <chrono>
#include <thread>

namespace kfast {
namespace {

using std::chrono::milliseconds;

constexpr std::uint32_t reset = 1;
constexpr std::uint32_t boot = 2;

// The chip needs microseconds. What takes longer is a wire with a capacitor at its end, as boards have for a
// button: 100 nF at a pull-up of 50 kOhm rise in 5 ms, and fall at once.
constexpr milliseconds settled{5};
constexpr milliseconds pulse{20};
// The boot ROM looks at BOOTSEL when it starts, long before USB can see it.
constexpr milliseconds held{100};

/// Lets both wires rise again, whatever happened.
class OpenLines {
public:
    explicit OpenLines(const BootLines& lines)
        : outputs_{lines.chip, std::array{GpioLine{lines.reset, true}, GpioLine{lines.boot, true}},
                   GpioDrive::open_drain}
    {
    }
    ~OpenLines()
    {
        try {
            outputs_.set(reset | boot, reset | boot);
        } catch (...) { // the failure to set a line has been reported already
        }
    }
    OpenLines(const OpenLines&) = delete;
    OpenLines& operator=(const OpenLines&) = delete;

    void pull(std::uint32_t line) { outputs_.set(line, 0); }
    void let_go(std::uint32_t line) { outputs_.set(line, line); }

private:
    GpioOutputs outputs_;
};

void pause(milliseconds time) { std::this_thread::sleep_for(time); }

}

void enter_boot_loader(const BootLines& lines)
{
    OpenLines open{lines};
    open.pull(boot);
    pause(settled);
    open.pull(reset);
    pause(pulse);
    open.let_go(reset);
    pause(held);
    open.let_go(boot);
}

}
