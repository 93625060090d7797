#include "boards/pico/app/settings.hpp"

#include "boards/pico/app/default_settings.hpp"
#include "firmware/settings/board_record.hpp"

#include <algorithm>
#include <cstddef>
#include <span>

extern "C" {
// From the linker script.
extern const std::byte settings_begin[];
extern const std::byte settings_end[];
}

namespace kfast::pico {
namespace {

bool is_blank(std::span<const std::byte> flash)
{
    return std::ranges::all_of(flash, [](std::byte byte) { return byte == std::byte{0xFF}; });
}

}

std::optional<BoardSettings> settings_for(BusKind bus)
{
    const std::span record = std::span{settings_begin, settings_end}.first(board_record_bytes);
    if (is_blank(record))
        return default_settings(bus);
    return read_board_record(record);
}

MaybeMistake mistake_in(const BoardSettings& settings) { return first_mistake(settings); }

}
