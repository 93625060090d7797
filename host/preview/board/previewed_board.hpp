#pragma once

#include "core/beam/beam_profile.hpp"
#include "core/math/point.hpp"
#include "core/pixel/pixel_format.hpp"
#include "host/fit/target.hpp"

#include <optional>
#include <string_view>

namespace kfast {

/// The display on which a preview shows a scene.
struct ShownDisplay {
    Size size;                              ///< of its panel
    std::string_view controller = {};       ///< of its panel; empty if none was named
    std::optional<PixelFormat> format = {}; ///< none: as the controller takes it
    std::optional<BeamProfile> beam = {};   ///< instead of a panel
};

/// The board that a preview uses for the fit report and the changed areas: `named`, otherwise a Raspberry
/// Pi Pico. Its display is the one that is shown. What is not named of that is as on the board: an ST7789 on
/// the Pico. If the board's controller does not take the pixels, it is one that does, where one is known.
/// Throws Failure if the board has a beam and a panel is shown, or the other way round.
fit::Target previewed_board(const ShownDisplay& shown, const std::optional<fit::Target>& named = {});

}
