#pragma once

#include "core/time.hpp"
#include "host/picture/frame_source.hpp"
#include "host/picture/picture.hpp"

#include <optional>
#include <vector>

namespace kfast {

/// A picture with those of the key frames before and after it behind: faint, the one before in a warm
/// colour, the one after in a cool one.
class OnionSkin {
public:
    /// `keys` are in order.
    explicit OnionSkin(std::vector<Time> keys);

    /// The picture of `source` at `moment`, which is the last that it shows. Pixels in which neither
    /// neighbour differs from it are exactly as `source` has them. Valid until the next call.
    const Picture& show(FrameSource& source, Time moment);
    /// The pictures of key frames are not known any more: an input was told.
    void forget();

private:
    struct Neighbour {
        std::optional<Time> key;
        Picture picture;
    };

    void look_up(Neighbour& neighbour, std::optional<Time> key, FrameSource& source);

    std::vector<Time> keys_;
    Neighbour before_;
    Neighbour after_;
    Picture picture_;
};

}
