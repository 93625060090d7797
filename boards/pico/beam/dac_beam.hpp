#pragma once

#include "firmware/run/beam.hpp"
#include "firmware/run/still_light.hpp"
#include "firmware/settings/board_settings.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::pico {

/// A beam that an MCP4922, or one with the same protocol, moves by x and y. State machines and the DMA do it
/// all: the processor only plots pictures.
class DacBeam {
public:
    /// The settings keep all rules (board_rules.hpp), are for a DAC, and outlive the beam. There is one.
    /// Needs start_clocks() and shutter::begin().
    explicit DacBeam(const BoardSettings& settings);

    const BeamProfile& profile() const { return profile_; }
    std::uint32_t room() const;

    bool takes_picture() const;
    void plot(std::span<const BeamPoint> points);
    void show();
    void park();

private:
    const BeamProfile& profile_;
    StillLight still_light_;  ///< of a laser
    std::size_t plotted_ = 0; ///< the picture that is being plotted
    std::size_t points_ = 0;  ///< of that picture, so far
};

static_assert(Beam<DacBeam>);

}
