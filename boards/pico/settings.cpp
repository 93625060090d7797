#include "boards/pico/settings.hpp"

#include "boards/pico/default_settings.hpp"
#include "firmware/board_record.hpp"

#include <cstddef>
#include <span>

extern "C" {
// From the linker script.
extern const std::byte settings_begin[];
extern const std::byte settings_end[];
}

namespace kfast::pico {

BoardSettings settings_for(BusKind bus)
{
    const std::span sector{settings_begin, settings_end};
    return read_board_record(sector).value_or(default_settings(bus));
}

}
