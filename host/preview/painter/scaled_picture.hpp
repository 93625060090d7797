#pragma once

#include "core/math/point.hpp"
#include "host/picture/picture.hpp"

#include <vector>

namespace kfast {

/// Where a picture stands in a larger or smaller space so that all of it is seen: centred, magnified by the
/// largest whole number that fits, or shrunk in proportion.
Rect placement(Size picture, Size space);

/// A picture laid on a rectangle of a window: enlarged with hard pixels, shrunk to the mean of the pixels
/// that a pixel of the window holds.
class ScaledPicture {
public:
    /// `picture` must outlive it. Neither has an empty side.
    ScaledPicture(const Picture& picture, Rect target);

    /// That place of the window lies within the target.
    Colour at(int x, int y) const;

private:
    /// The pixels of the picture from `first` to before `end`.
    struct Share {
        int first;
        int end;
    };
    static std::vector<Share> shares(int pixels, int target);
    Colour mean(Share columns, Share rows) const;

    const Picture& picture_;
    Rect target_;
    std::vector<Share> columns_;
    std::vector<Share> rows_;
};

}
