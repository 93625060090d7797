#pragma once

#include "core/player.hpp"
#include "core/playhead.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace kfast::bench {

/// The pictures of a scene that plays on and on, frame by frame, whole.
class SteadyPictures {
public:
    /// The first one is that of the stretch's beginning. `scene`'s bytes must outlive it.
    SteadyPictures(const SceneView& scene, const PlayRange& stretch);
    SteadyPictures(const SteadyPictures&) = delete;

    /// Goes on to the next picture.
    void advance();
    /// Bytes of the pixels in which this picture differs from the one before: the least that a panel can be
    /// sent.
    std::uint32_t changed_bytes() const;

private:
    void draw();

    std::vector<std::byte> block_;
    Playhead playhead_;
    Player player_;
    std::vector<std::byte> picture_;
    std::vector<std::byte> before_;
};

}
