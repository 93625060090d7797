#pragma once

#include "host/picture/frame_source.hpp"
#include "host/simulator/simulated_board.hpp"

#include <cstddef>
#include <span>

namespace kfast {

/// What a board with an SSD0323 shows: the firmware's loop and driver run in the simulator, for each picture
/// anew, and the pictures are decoded from the bytes on its bus.
class BoardSource : public FrameSource {
public:
    /// `scene` is a checked scene and must outlive the source.
    explicit BoardSource(std::span<const std::byte> scene);

    /// Throws Failure for a mistake on the bus.
    const Frame& show(Time moment) override;
    Pace pace() const override { return Pace::by_frames; }

private:
    SimulatedBoard board_;
    Frame frame_;
};

}
