#pragma once

#include "core/beam/beam_profile.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace kfast {

/// The 64 colours that hold in an ILDA file until it has a palette: red 0, yellow 16, green 24, cyan 31,
/// blue 40, magenta 48, white 56. The specification suggests them; several programs agree on each.
std::span<const Colour> default_ilda_palette();

/// The colours of points by numbers. It begins with the default ones, in their places, so that these are
/// right for whoever passes over palettes as well.
class IldaPalette {
public:
    IldaPalette();
    /// With what is lit in all these pictures.
    explicit IldaPalette(std::span<const std::vector<BeamPoint>> frames);

    /// Makes room for what is lit among them, as far as there is some.
    void add(std::span<const BeamPoint> points);
    /// The number of the colour, or of the one that is nearest to it.
    std::uint8_t index(Colour colour) const;

    std::span<const Colour> colours() const { return colours_; }
    /// It says more than the default one.
    bool is_needed() const { return colours_.size() > default_ilda_palette().size(); }
    /// Not all colours have found room.
    bool is_too_small() const { return is_too_small_; }

private:
    std::vector<Colour> colours_;
    bool is_too_small_ = false;
};

}
