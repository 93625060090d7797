#pragma once

#include "host/art/ease.hpp"

#include <string>
#include <vector>

namespace kfast::scene_text {

/// A part of a way between two keys.
struct EasePiece {
    double time = 0; ///< when it begins, a share of the time of the whole
    double way = 0;  ///< where it begins, a share of the whole way
    art::Ease ease;
};

/// The same way in as few pieces as there must be so that each is a law of scenes, whose control points are
/// within -2 and 3: where it turns round, if the ease exceeds that. Times rise.
std::vector<EasePiece> ease_pieces(const art::Ease& ease);

/// "constant", "hold", "ease-in" or "bezier(0.1,0,0.9,1)": of an ease that is a law of scenes.
std::string law_of(const art::Ease& ease);

}
