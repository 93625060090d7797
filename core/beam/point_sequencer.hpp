#pragma once

#include "core/beam/beam_lines.hpp"
#include "core/beam/beam_route.hpp"
#include "core/beam/line_interpolator.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

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
    std::uint32_t period_ = 0; ///< after that many points the same ones come again
    bool is_reversed_ = false;
    Colour colour_;
};

/// The path of a beam along a route and back to its beginning, as one *run* of points after another: the beam
/// rests at a place, or goes along a line at even steps.
///
/// Where there are no legs, it is parked, blanked, for one point.
///
/// A leg begins where the one before ends, and the first one where the last one ends: the beam waits, travels
/// and waits, blanked, then follows the line. If the line begins where the one before has ended, there is
/// only a corner between them.
class PointSequencer {
public:
    /// `lines`, `legs` and the step profile must outlive it. For `pause` points the beam rests, blanked,
    /// before it begins.
    PointSequencer(const BeamLines& lines, std::span<const BeamLeg> legs, const StepProfile& step_profile,
                   std::uint32_t pause);

    /// Goes to the next run, of at least one point, whatever is left of this one. False if there is none.
    bool next_run();
    /// The number of points of the run that next() has not given.
    std::uint32_t left() const { return left_; }
    bool is_lit() const { return is_lit_; }
    /// The colour of the line that the run is of.
    Colour colour() const { return line_.colour(); }
    /// The length along which the beam goes in the run; 0 where it rests.
    std::uint32_t length() const { return length_; }

    /// The position of the next point of the run.
    FieldPoint next();
    /// Starts from the beginning again.
    void restart();

private:
    enum class Phase : std::uint8_t { leave, travel, arrive, start, line, corner };

    void begin_phase();
    void begin_leg();
    void begin_travel();
    void begin_line();
    void rest(FieldPoint at, std::uint32_t points, bool is_lit);
    void go(FieldPoint to, std::uint32_t length, std::uint32_t step, bool is_lit);
    std::uint32_t find_end();
    void set_out();
    void enter_piece_at(std::uint32_t distance);
    std::uint32_t start_points() const;
    std::uint32_t corner_points() const;
    bool is_joined(std::size_t leg) const;
    std::size_t before(std::size_t leg) const { return (leg == 0 ? legs_.size() : leg) - 1; }
    LegCorners corners(std::size_t leg) const { return {*lines_, legs_[leg]}; }

    const BeamLines* lines_;
    std::span<const BeamLeg> legs_;
    StepProfile step_profile_;
    std::uint32_t pause_;

    std::size_t leg_ = 0; ///< after the last one, the route is done
    Phase phase_ = Phase::leave;
    LegCorners line_; ///< of the leg
    std::uint32_t lit_step_ = 1;
    FieldPoint came_from_;           ///< where the leg before has ended
    bool is_joined_ = false;         ///< whether the line begins there
    std::uint32_t corner_ = 0;       ///< of the line, where the next run begins
    std::uint32_t corner_dwell_ = 0; ///< there

    // The run.
    std::uint32_t left_ = 0;
    std::uint32_t length_ = 0;
    bool is_lit_ = false;
    bool rests_ = true;
    FieldPoint end_;
    bool has_set_out_ = false; ///< whether what follows is known
    BeamSteps steps_;
    LineInterpolator piece_;        ///< the current one
    std::uint32_t piece_begin_ = 0; ///< distance from the beginning of the run
    std::uint32_t piece_length_ = 0;
    std::uint32_t piece_corner_ = 0; ///< of the line, where the piece ends
};

}
