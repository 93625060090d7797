#pragma once

#include "host/failure.hpp"

#include <cstddef>
#include <string>

namespace kfast {

/// An animated GIF or PNG is put together in memory; browsers give up long before.
inline constexpr std::size_t most_film_bytes = std::size_t{1} << 30;

/// Throws Failure if one became larger. `what` is its kind: "GIF".
inline void require_film_size(std::size_t bytes, const char* what)
{
    if (bytes > most_film_bytes)
        throw Failure(
            std::string{"the "} + what +
            " would be larger than 1 GiB: play less with --clip, choose a smaller --scale or --size, "
            "or make an .mp4");
}

}
