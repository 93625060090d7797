#pragma once

#include "core/math/point.hpp"
#include "host/picture/picture.hpp"

#include <vector>

namespace kfast {

/// Where a picture is in a larger or smaller space so that all of it is visible: centred, magnified by the
/// largest whole number that fits, or shrunk in proportion.
Rect placement(Size picture, Size space);

/// A picture scaled to a rectangle of a window: enlarged with hard pixels, shrunk to the mean of the pixels
/// that a pixel of the window holds.
class ScaledPicture {
public:
    /// `picture` must outlive it. Neither has an empty side.
    ScaledPicture(const Picture& picture, Rect target);

    /// The position in the window must be within the target.
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
