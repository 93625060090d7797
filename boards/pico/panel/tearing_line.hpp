#pragma once

#include "firmware/settings/board_settings.hpp"

#include <cstdint>

namespace kfast::pico {

/// Listens to the display's TE line, which rises when a picture has been shown. There is one.
class TearingLine {
public:
    /// Counts from now on; never, without a pin.
    explicit TearingLine(Pin pin);

    /// How often the line has risen; it wraps.
    std::uint32_t pictures() const;
};

}
