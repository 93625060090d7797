#pragma once

#include "core/math/point.hpp"
#include "core/pixel/paint_style.hpp"
#include "host/art/prepare/prepare.hpp"
#include "host/program/progress_callback.hpp"
#include "host/svg/poses/key_options.hpp"

#include <optional>
#include <string>

namespace kfast::importing {

/// How files of other programs are made into scenes.
struct Options {
    double tolerance = art::default_tolerance; ///< canvas pixels, 0 or more
    std::optional<Size> size;                  ///< the art is scaled so that its canvas just fits into it
    std::optional<Colour> background;          ///< opaque, for files that do not specify one
    std::string animation;                     ///< of a dotLottie file; "": the one that it begins with
    svg::KeyOptions drawings;                  ///< how drawings of SVG become keys
    ProgressCallback on_progress = ignore_progress;
};

}
