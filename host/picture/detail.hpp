#pragma once

#include "core/raster/picture.hpp"

#include <cstdint>
#include <string>

namespace kfast {

/// What of a picture found room for its outlines, the least first.
enum class Detail : std::uint8_t {
    parts_missing,
    coarse, ///< all of it, its curves in fewer pieces
    full,
};

Detail detail_of(const raster::Picture& picture);

/// The detail of the pictures that a source shows.
class ShownDetail {
public:
    void add(const raster::Picture& picture);

    Detail min() const { return min_; }
    /// Of the last picture, in words for FrameSource::facts(); empty if it is full.
    std::string text() const;

private:
    Detail last_ = Detail::full;
    Detail min_ = Detail::full;
};

}
