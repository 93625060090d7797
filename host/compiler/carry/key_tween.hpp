#pragma once

#include "core/time/velocity_law.hpp"
#include "core/time/time.hpp"
#include "host/compiler/match/match_by_length.hpp"
#include "host/text/source.hpp"

#include <cstdint>
#include <vector>

namespace kfast {

/// A key as it is stored, and the way from it to the next. The last one leads nowhere: its ends are its
/// drawing twice.
struct KeyTween {
    Time time;
    LawPair laws;
    MatchedDrawings ends;
    SourceSpan place; ///< of the key
};

/// All that an object has.
struct KeyTweens {
    std::vector<KeyTween> tweens;
    /// Of the ways of drawings that backbones carry: 2^unit_bits sixteenths of a pixel stand for a segment.
    std::uint32_t unit_bits = 0;
};

}
