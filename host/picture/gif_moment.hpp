#pragma once

#include "host/picture/timeline.hpp"

#include <vector>

namespace kfast {

/// A picture of a GIF: what it shows, and for how long.
struct GifMoment {
    Time time;
    int centiseconds = 0;
};

/// One period of what is played, frame by frame. The delays follow the scene's clock without drift (30 fps:
/// 3, 3, 4). Browsers show delays of 1 as 10, so scenes above 50 fps are drawn 50 times a second.
std::vector<GifMoment> gif_moments(const Timeline& timeline);

}
