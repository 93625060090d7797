#pragma once

#include "core/time.hpp"
#include "host/picture/frame.hpp"

namespace kfast {

/// Draws a scene on one panel. Which one is chosen at run time, hence virtual.
class FrameSource {
public:
    virtual ~FrameSource() = default;

    /// The picture at `time` (wrapped by the scene's loop mode). Valid until the next call.
    virtual const Frame& show(Time time) = 0;
};

}
