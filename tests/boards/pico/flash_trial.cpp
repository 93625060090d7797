// An image for tests: changes flash that the program does not use, and tells over the log what it reads there
// then.

#include "boards/pico/app/log.hpp"
#include "boards/pico/chip/clock.hpp"
#include "boards/pico/chip/clocks.hpp"
#include "boards/pico/chip/flash.hpp"
#include "boards/pico/chip/watchdog.hpp"
#include "core/bytes/crc32.hpp"

#include <array>
#include <string_view>

namespace kfast::pico {
namespace {

constexpr std::uint32_t place = 1 << 20;
constexpr std::size_t size = 2 * flash::sector_bytes;
constexpr Pin log_pin = 0;

std::array<std::byte, 2 * flash::page_bytes> pages;

void print(std::string_view what)
{
    const auto* const flash_begin = reinterpret_cast<const std::byte*>(0x1000'0000);
    Crc32 sum;
    sum.add({flash_begin + place, size});
    write_text(log, what);
    log.write(' ');
    write_hex(log, sum.value());
    log.write('\n');
}

void try_flash()
{
    print("BEFORE");
    flash::erase(place, size);
    print("ERASED");
    for (std::size_t i = 0; i < pages.size(); ++i)
        pages[i] = static_cast<std::byte>(i * 7);
    flash::program(place + flash::sector_bytes - flash::page_bytes, pages);
    print("PROGRAMMED");
    flash::erase(place, flash::sector_bytes);
    print("HALF");
    log.send_waiting();
}

}

}

int main()
{
    using namespace kfast::pico;
    start_clocks();
    watchdog::start();
    Clock clock;
    clock.begin();
    log.begin(log_pin);
    try_flash();
    while (true)
        clock.sleep_until(clock.now() + kfast::Microseconds{1'000'000});
}
