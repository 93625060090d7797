#pragma once

#include "core/time/time.hpp"
#include "host/picture/detail.hpp"
#include "host/picture/frame.hpp"
#include "host/picture/input_receiver.hpp"

#include <string>

namespace kfast {

/// When a picture changes while a scene plays.
enum class Pace {
    smooth,    ///< whenever it is asked
    by_frames, ///< at the frames of the scene alone
};

/// Draws a scene on one panel. Which one is chosen at run time, hence virtual.
class FrameSource : public InputReceiver {
public:
    /// The picture at a moment of the timeline, the scene's very end included. Valid until the next call.
    virtual const Frame& show(Time moment) = 0;
    /// Does what goes along with the picture at a moment, sound for instance, when one that was kept is shown
    /// in place of a new one.
    virtual void accompany(Time /*moment*/) {}
    virtual Pace pace() const { return Pace::smooth; }
    /// What is to be said about the picture that was shown last, on one line; empty if nothing.
    virtual std::string facts() const { return {}; }
    /// Of all pictures so far.
    virtual Detail min_detail() const { return Detail::full; }
    /// From the next picture on, also what nobody sees on the display, where there is such a thing.
    virtual void reveal(bool /*hidden*/) {}
};

}
