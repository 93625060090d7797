#pragma once

#include "host/preview/board_changes.hpp"

namespace kfast {

/// How long a board takes for the pictures of a scene, each after the one that was asked for before.
class BoardPace {
public:
    /// `scene`'s bytes must outlive it; `board` has a panel.
    BoardPace(const SceneView& scene, const fit::Target& board, Fit fit);

    /// To be told what the scene takes from outside.
    ToldInputs& inputs() { return changes_; }
    double seconds_for(Time moment);

private:
    fit::Target board_;
    BoardChanges changes_;
};

}
