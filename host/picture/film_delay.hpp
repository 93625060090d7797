#pragma once

#include <cstdint>

namespace kfast {

/// How long an animated PNG shows a picture: a fraction of a second.
struct FilmDelay {
    std::uint16_t numerator = 0;
    std::uint16_t denominator = 1;
    bool is_exact = true;
};

/// The fraction for so many ticks of a scene's clock, at least one, with `frame_rate` frames in 1000 seconds,
/// at least 1. Where no fraction of two 16-bit numbers is exact, the last of the convergents of its continued
/// fraction that still is one; 65535 s where it is longer.
FilmDelay film_delay(std::int64_t ticks, std::uint32_t frame_rate);

}
