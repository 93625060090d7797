#pragma once

#include "host/picture/frame_source.hpp"
#include "host/picture/timeline.hpp"
#include "host/simulator/simulated_board.hpp"

#include <cstddef>
#include <span>

namespace kfast {

/// What a board with an SSD0323 shows: the firmware's loop and driver run in the simulator, and the pictures
/// are decoded from the bytes on its bus. Between two frames the earlier one stays, as on the board.
class BoardSource : public FrameSource {
public:
    /// `scene` is a checked scene and must outlive the source. Throws Failure for a mistake on the bus.
    explicit BoardSource(std::span<const std::byte> scene, const Timeline& timeline);

    const Frame& show(Time time) override;

private:
    Timeline timeline_;
    SimulatedBoard board_;
    Frame frame_;
};

}
