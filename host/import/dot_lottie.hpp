#pragma once

#include "host/archive/archive.hpp"
#include "host/art/document/document.hpp"
#include "host/art/losses.hpp"

#include <cstddef>
#include <optional>
#include <string>

namespace kfast::importing {

/// How the manifest of a dotLottie file has an animation played.
struct Playing {
    std::optional<Loop> loop;
    std::optional<art::Rgb> background;
    double speed = 1; ///< above 0
};

/// One animation of a dotLottie file.
struct PackedAnimation {
    std::string text; ///< Lottie
    Playing playing;
};

/// Reads a dotLottie file of version 1 or 2 (https://dotlottie.io/spec/1.0, /spec/2.0): the animation
/// `wanted`, or if that is empty the one that the manifest begins with. What else it holds is added to
/// `losses`. Throws Failure, which names the file, where there is none.
PackedAnimation read_dot_lottie(const std::string& name, const archive::ZipFile& file,
                                const std::string& wanted, std::size_t max_bytes, art::Losses& losses);

}
