#pragma once

#include "firmware/chip/microseconds.hpp"

#include <cstdint>

namespace kfast {

/// Waits until a display has shown a picture, which its TE line signals: sending then begins after the row
/// that is being shown. A line that stays silent is not wired: no frame waits for it any more, until it
/// signals again.
class TearingWait {
public:
    /// Longer than any panel takes for a picture.
    static constexpr Microseconds patience{40'000};

    /// `edges()` counts the rising edges of the line, `now()` is the time.
    template <class Edges, class Now>
    void wait(Edges&& edges, Now&& now)
    {
        const std::uint32_t before = edges();
        if (is_silent_ && before == heard_)
            return;
        is_silent_ = false;
        const Microseconds end = now() + patience;
        while (edges() == before && !is_silent_)
            is_silent_ = reached(now(), end);
        heard_ = edges();
    }

private:
    bool is_silent_ = false;
    std::uint32_t heard_ = 0; ///< edges until the last wait ended
};

}
