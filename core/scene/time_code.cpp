#include "core/scene/time_code.hpp"

#include "core/scene/kfb_limits.hpp"

#include <algorithm>

namespace kfast {

Time read_time_code(ByteReader& bytes)
{
    constexpr std::uint32_t beyond = kfb::max_time + 1;
    const std::uint32_t code = bytes.varint();
    const std::uint32_t number = std::min(code / 2, beyond);
    const bool in_ticks = code % 2 != 0;
    constexpr std::uint32_t frame = Time::ticks_per_frame;
    const std::uint32_t ticks = in_ticks ? number : std::min(number, beyond / frame + 1) * frame;
    return {static_cast<std::int32_t>(std::min(ticks, beyond))};
}

}
