#pragma once

#include "core/pixel/paint_style.hpp"
#include "host/beam/light_sheet.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace kfast {

/// What glows where the beam hits it.
enum class Phosphor : std::uint8_t {
    green,
    blue,
    amber,
    white,
    rgb, ///< in the colours of the scene, as a laser or a colour tube
};

struct PhosphorName {
    std::string_view name;
    Phosphor value;
};

std::span<const PhosphorName> phosphor_names();

/// Light of one or three colours as a camera takes it: much light becomes white, and more does not become
/// lighter. Light of 1 is what it is exposed for: a little less than white.
class Film {
public:
    explicit Film(Phosphor phosphor);

    /// How many colours of light there are: 3 for rgb, else 1.
    int channels() const { return phosphor_ == Phosphor::rgb ? 3 : 1; }
    /// The light of a beam of this colour, 0 … 1 each.
    Light light_of(Colour colour) const;
    /// The colour of light of 0 or more. With one channel there are no more than 256 colours.
    Colour developed(const Light& light) const;

private:
    std::uint8_t level(float light) const;

    Phosphor phosphor_;
    std::vector<float> light_;         ///< of a channel of the scene's colours
    std::vector<std::uint8_t> levels_; ///< of light in steps
    std::vector<Colour> colours_;      ///< of levels, with one channel
};

}
