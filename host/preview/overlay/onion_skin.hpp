#pragma once

#include "core/pixel/paint_style.hpp"
#include "core/time/time.hpp"
#include "host/picture/frame_source.hpp"
#include "host/picture/picture.hpp"

#include <optional>
#include <span>

namespace kfast {

/// Paints over `picture` what `neighbour` has painted elsewhere, in the colour `tint`.
///
/// A pixel of the neighbour counts by how far it differs from the picture and from `background`, whichever is
/// less: by d, the largest difference of a channel, three times, 255 at most. Each channel p of the picture
/// becomes p + (tint - p) w faintness / 255^2, rounded to nearest, halves away from p. Where d is 0, that is
/// p. All three pictures are of one size.
void lay_skin(Picture& picture, const Picture& neighbour, const Picture& background, Colour tint);

/// A picture with those of the key frames before and after it: faint, the one before in a warm colour, the
/// one after in a cool one.
class OnionSkin {
public:
    static constexpr Colour warm{255, 128, 48};
    static constexpr Colour cool{64, 144, 255};
    static constexpr int faintness = 128; ///< of 255

    /// `background` is that of the scene. On the screen of a beam that is black anyway.
    explicit OnionSkin(Colour background) : background_{background} {}

    /// The picture of `source` at `moment`, which is the last that it shows, between those of `keys`, which
    /// are in order. Pixels where nothing of the neighbours is visible are exactly as `source` has them.
    /// Valid until the next call.
    const Picture& show(FrameSource& source, Time moment, std::span<const Time> keys);
    /// Drops the pictures of key frames: an input was set, or the source is another.
    void forget();

private:
    struct Neighbour {
        std::optional<Time> key;
        Picture picture;
    };

    static void look_up(Neighbour& neighbour, std::optional<Time> key, FrameSource& source);

    Colour background_;
    Picture empty_; ///< the background alone
    Neighbour before_;
    Neighbour after_;
    Picture picture_;
};

}
