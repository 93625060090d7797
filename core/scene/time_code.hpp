#pragma once

#include "core/bytes/byte_reader.hpp"
#include "core/scene/kfb_limits.hpp"
#include "core/time/time.hpp"

#include <algorithm>
#include <cstdint>

namespace kfast {

/// Reads a time code of the scene format: twice the frames, or twice the ticks and one. A time beyond the
/// format's limit stays just beyond it, so that sums do not overflow before they are refused.
Time read_time_code(ByteReader& bytes);

/// Frames in 1000 seconds as the scene format has them: twice the frames in a second, or twice those in 1000
/// seconds and one. A rate beyond the format's limit stays beyond it.
constexpr std::uint32_t rate_of(std::uint32_t code)
{
    const std::uint32_t number = std::min(code / 2, kfb::max_frame_rate + 1);
    return code % 2 != 0 ? number : number * 1000;
}

}
