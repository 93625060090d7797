#pragma once

#include "boards/pico/dac_beam.hpp"
#include "boards/pico/stage_board.hpp"

namespace kfast::pico {

/// A Pico with a vector display.
class BeamBoard : public StageBoard {
public:
    /// All of them must outlive the board. The computer has begun.
    BeamBoard(DacBeam& beam, const BoardSettings& settings, const Clock& clock, const Computer& computer)
        : StageBoard{settings, clock, computer}, beam_{beam}
    {
    }

    DacBeam& beam() { return beam_; }

private:
    DacBeam& beam_;
};

}
