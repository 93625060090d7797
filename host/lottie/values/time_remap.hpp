#pragma once

#include "host/art/budget.hpp"
#include "host/art/document/document.hpp"

#include <vector>

namespace kfast::lottie {

/// Between two times of the scene, the frame of a composition changes linearly, in either direction.
struct TimePiece {
    double from = 0; ///< of the scene
    double to = 0;
    double begin = 0; ///< of the composition
    double end = 0;
};

/// Pieces of a span, without gaps. `frame` is that of the composition over frames of the scene; where it is
/// eased there is a piece for each frame.
std::vector<TimePiece> time_pieces(const art::Channel& frame, const art::Span& span, art::Budget& budget);

/// Converts times of the composition to those of the scene.
void retime(std::vector<art::Node>& nodes, const std::vector<TimePiece>& pieces, art::Budget& budget);

}
