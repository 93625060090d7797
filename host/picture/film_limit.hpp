#pragma once

#include "host/program/failure.hpp"

#include <cstddef>
#include <string>

namespace kfast {

/// How large an animation that is put together in memory may become; browsers give up long before.
struct FilmLimit {
    std::size_t mebibytes = 1024;

    /// Throws Failure if one became larger. `what` is its kind: "GIF".
    void require(std::size_t bytes, const char* what) const
    {
        if (bytes > mebibytes << 20)
            throw Failure(std::string{"the "} + what + " would be larger than " + std::to_string(mebibytes) +
                          " MiB: play less with --clip, choose a smaller --scale or --size, or make an .mp4");
    }
};

}
