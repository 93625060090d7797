#pragma once

#include "core/math/point.hpp"
#include "host/beam/beam_deflection.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace kfast {

/// Light of up to three colours.
using Light = std::array<float, 3>;

/// The light that fell on each pixel of a screen. Positions are in pixels; that of a pixel is its middle.
/// Light beyond the edges is lost.
class LightSheet {
public:
    /// Of `channels` colours, at most three.
    LightSheet(Size size, int channels);

    void clear();
    /// Spreads `light` evenly along a line.
    void add_line(BeamPlace from, BeamPlace to, const Light& light);
    /// Every point becomes a spot: a Gaussian of that standard deviation, with a fraction of its light in a
    /// wide halo around it.
    void spread(double deviation);

    Light at(std::size_t pixel) const;
    Size size() const { return size_; }

private:
    void add(BeamPlace at, const Light& light);
    std::span<float> plane(int channel);

    Size size_;
    int channels_;
    std::size_t pixels_;
    std::vector<float> planes_; ///< one after the other, rows from the top
};

}
