#pragma once

#include "core/player.hpp"
#include "host/picture/frame_source.hpp"
#include "host/simulator/simulated_board.hpp"

#include <cstddef>
#include <span>

namespace kfast {

/// What a board with an SSD0323 shows: the firmware sends to the simulator what differs from the picture
/// before, and the pictures are decoded from the bytes on its bus.
class BoardSource : public FrameSource {
public:
    /// `scene` is a checked scene and must outlive the source.
    explicit BoardSource(std::span<const std::byte> scene);
    BoardSource(const BoardSource&) = delete;

    /// Throws Failure for a mistake on the bus.
    const Frame& show(Time moment) override;
    Pace pace() const override { return Pace::by_frames; }

private:
    SimulatedBoard board_;
    Player player_;
    Frame frame_;
};

}
