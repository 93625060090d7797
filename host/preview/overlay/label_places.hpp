#pragma once

#include "host/preview/overlay/overlay.hpp"

#include <cstddef>
#include <set>
#include <string>
#include <utility>

namespace kfast {

/// Where labels stand on a picture, so that none lies on another.
class LabelPlaces {
public:
    static constexpr std::size_t max = 400;

    /// `scale` is how many pixels of a window a pixel of the panel takes.
    explicit LabelPlaces(double scale) : scale_{scale} {}

    /// Takes the room for a text at `at`, if it is free and there are not too many.
    bool take(PanelSpot at, const std::string& text);

private:
    double scale_;
    std::size_t count_ = 0;
    std::set<std::pair<int, int>> cells_; ///< of the size of a letter, that are taken
};

}
