#pragma once

#include "core/beam/beam_lines.hpp"
#include "core/beam/beam_route.hpp"

#include <cstdint>

namespace kfast {

/// The corners of a line in the order in which a leg follows them.
class LegCorners {
public:
    LegCorners() = default;
    /// `lines` must outlive it.
    LegCorners(const BeamLines& lines, const BeamLeg& leg);

    std::uint32_t size() const { return size_; }
    FieldPoint operator[](std::uint32_t number) const;
    FieldPoint front() const { return (*this)[0]; }
    FieldPoint back() const { return (*this)[size_ - 1]; }
    Colour colour() const { return colour_; }

private:
    const FieldPoint* points_ = nullptr; ///< of the line
    std::uint32_t size_ = 0;
    std::uint32_t first_ = 0;
    std::uint32_t period_ = 0; ///< after so many points the same ones come again
    bool is_reversed_ = false;
    Colour colour_;
};

}
