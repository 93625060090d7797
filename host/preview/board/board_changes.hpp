#pragma once

#include "host/fit/target.hpp"
#include "host/preview/board/standalone_player.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace kfast {

/// What is sent over the bus for one picture.
struct SentAreas {
    std::vector<Rect> areas;
    std::size_t bytes = 0; ///< of pixels, and of the commands for areas

    /// "2 areas, 1312 bytes, 4 % of the panel", rounded to nearest, but no less than 1 % if there are some.
    std::string text(Size panel) const;
};

/// Draws a scene as a board does, and reports what it sends to its panel.
class BoardChanges final : public StandalonePlayer {
public:
    /// `scene`'s bytes must outlive it. `board` has a panel. If its bands are less than the rows that the
    /// panel takes together, they are taken to be as large.
    BoardChanges(const SceneView& scene, const fit::Target& board, Fit fit);

    /// The areas for the picture at a time, after the one that was asked for before; if that is the same time
    /// and nothing differs, what was returned then. The first one comes after the picture a frame earlier; at
    /// the beginning of the scene nothing is shown before it.
    const SentAreas& show(Time moment);

private:
    SentAreas sent_for(Time moment);

    fit::Display display_;
    std::vector<std::byte> band_;
    std::optional<Time> shown_;
    SentAreas sent_;
};

/// How long a board takes for the pictures of a scene, each after the one that was asked for before.
class BoardPace {
public:
    /// `scene`'s bytes must outlive it; `board` has a panel.
    BoardPace(const SceneView& scene, const fit::Target& board, Fit fit);

    /// For setting the inputs of the scene.
    InputReceiver& inputs() { return changes_; }
    double seconds_for(Time moment);

private:
    fit::Target board_;
    BoardChanges changes_;
};

}
