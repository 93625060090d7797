#include "core/beam/point_sequencer.hpp"

#include "core/beam/line_interpolator.hpp"

namespace kfast {

LegCorners::LegCorners(const BeamLines& lines, const BeamLeg& leg) : is_reversed_{leg.is_reversed}
{
    const BeamLine& line = lines.line(leg.line);
    points_ = lines.points(line).data();
    size_ = line.points;
    colour_ = line.colour;
    const bool is_closed = lines.is_closed(line);
    period_ = is_closed ? size_ - 1 : size_;
    if (is_closed)
        first_ = leg.start;
    else if (is_reversed_)
        first_ = size_ - 1;
}

FieldPoint LegCorners::operator[](std::uint32_t number) const
{
    if (is_reversed_)
        return points_[first_ < number ? first_ + period_ - number : first_ - number];
    const std::uint32_t place = first_ + number;
    return points_[place < period_ ? place : place - period_];
}

namespace {

/// A run is not longer than this and another piece, so that lengths fit in 32 bits.
constexpr std::uint32_t longest_run = 1U << 31;

BeamDirection direction(FieldPoint from, FieldPoint to)
{
    const FieldVector delta = to - from;
    return {delta, delta.length()};
}

}

PointSequencer::PointSequencer(const BeamLines& lines, std::span<const BeamLeg> legs,
                               const StepProfile& step_profile, std::uint32_t pause)
    : lines_{&lines}, legs_{legs}, step_profile_{step_profile}, pause_{pause}
{
}

bool PointSequencer::next_run()
{
    if (legs_.empty()) {
        rest(step_profile_.profile().park, leg_ == 0 ? 1 : 0, false);
        leg_ = 1;
        return left_ != 0;
    }
    left_ = 0;
    while (left_ == 0 && (phase_ != Phase::leave || leg_ != legs_.size()))
        begin_phase();
    return left_ != 0;
}

void PointSequencer::restart()
{
    leg_ = 0;
    phase_ = Phase::leave;
    left_ = 0;
}

/// Each phase sets the one that comes after it.
void PointSequencer::begin_phase()
{
    switch (phase_) {
    case Phase::leave:
        phase_ = Phase::travel;
        return begin_leg();
    case Phase::travel:
        phase_ = is_joined_ ? Phase::start : Phase::arrive;
        return begin_travel();
    case Phase::arrive:
        phase_ = Phase::start;
        return rest(line_.front(), step_profile_.dwell(step_profile_.profile().arrival_dwell), false);
    case Phase::start:
        phase_ = line_.size() > 1 ? Phase::line : Phase::leave;
        rest(line_.front(), start_points(), true);
        leg_ += phase_ == Phase::leave ? 1 : 0;
        return;
    case Phase::line:
        phase_ = Phase::corner;
        return begin_line();
    case Phase::corner:
        const bool is_done = corner_ + 1 == line_.size();
        phase_ = is_done ? Phase::leave : Phase::line;
        rest(end_, corner_points(), true);
        leg_ += is_done ? 1 : 0;
        return;
    }
}

void PointSequencer::begin_leg()
{
    came_from_ = corners(before(leg_)).back();
    line_ = corners(leg_);
    is_joined_ = is_joined(leg_);
    lit_step_ = step_profile_.lit_step(line_.colour());
    corner_ = 0;
    const std::uint32_t pause = leg_ == 0 ? pause_ : 0;
    rest(came_from_, is_joined_ ? 0 : step_profile_.dwell(step_profile_.profile().leave_dwell) + pause,
         false);
}

/// Whether a leg's line begins where the one before ends, and nothing comes between them.
bool PointSequencer::is_joined(std::size_t leg) const
{
    return (leg != 0 || pause_ == 0) && corners(before(leg)).back() == corners(leg).front();
}

void PointSequencer::begin_travel()
{
    const std::uint32_t length = (line_.front() - came_from_).length();
    const std::uint32_t step = step_profile_.travel_step();
    go(line_.front(), length, step == 0 ? longest_run : step, false);
}

void PointSequencer::begin_line()
{
    piece_corner_ = corner_;
    const std::uint32_t length = find_end();
    go(line_[corner_], length, lit_step_, true);
}

/// Goes to the next corner that is to be a point, and returns how far it is.
std::uint32_t PointSequencer::find_end()
{
    corner_dwell_ = 0;
    std::uint32_t length = 0;
    BeamDirection before;
    FieldPoint from = line_[corner_];
    for (;;) {
        const FieldPoint to = line_[corner_ + 1];
        const FieldVector delta = to - from;
        const std::uint32_t piece = delta.length();
        const BeamDirection after{delta, piece};
        if (after.is_known() && step_profile_.hits_corners()) {
            const BeamTurn turn{before, after};
            if (turn.is_corner()) {
                corner_dwell_ = turn.share_of(step_profile_.profile().corner_dwell);
                return length;
            }
            before = after;
        }
        length += piece;
        ++corner_;
        if (corner_ + 1 == line_.size() || length >= longest_run)
            return length;
        from = to;
    }
}

/// The first point of a line, unless it is the last one of the line before.
std::uint32_t PointSequencer::start_points() const
{
    if (line_.size() == 1)
        return step_profile_.dot_dwell(line_.colour());
    if (!is_joined_)
        return 1 + step_profile_.dwell(step_profile_.profile().lit_dwell);
    const LegCorners last = corners(before(leg_));
    if (last.size() == 1)
        return 0;
    const BeamTurn turn{direction(last[last.size() - 2], last.back()), direction(line_[0], line_[1])};
    return step_profile_.dwell(turn.share_of(step_profile_.profile().corner_dwell));
}

/// The points besides the one that the run before has ended with.
std::uint32_t PointSequencer::corner_points() const
{
    if (corner_ + 1 != line_.size())
        return step_profile_.dwell(corner_dwell_);
    const std::size_t next = leg_ + 1 == legs_.size() ? 0 : leg_ + 1;
    return is_joined(next) ? 0 : step_profile_.dwell(step_profile_.profile().lit_dwell);
}

void PointSequencer::rest(FieldPoint at, std::uint32_t points, bool is_lit)
{
    rests_ = true;
    left_ = points;
    length_ = 0;
    is_lit_ = is_lit;
    end_ = at;
}

void PointSequencer::go(FieldPoint to, std::uint32_t length, std::uint32_t step, bool is_lit)
{
    rests_ = false;
    left_ = length == 0 ? 0 : (length - 1) / step + 1;
    length_ = length;
    is_lit_ = is_lit;
    end_ = to;
    has_set_out_ = false;
}

FieldPoint PointSequencer::next()
{
    --left_;
    if (rests_ || left_ == 0)
        return end_;
    if (!has_set_out_)
        set_out();
    const std::uint32_t distance = steps_.next();
    if (distance - piece_begin_ > piece_length_)
        enter_piece_at(distance);
    return piece_.at(distance - piece_begin_);
}

/// Only output needs divisions: counting does without them. One point has been taken already.
void PointSequencer::set_out()
{
    has_set_out_ = true;
    steps_ = {length_, left_ + 1};
    piece_begin_ = 0;
    piece_length_ = 0;
}

/// Pieces without a point on them are skipped.
void PointSequencer::enter_piece_at(std::uint32_t distance)
{
    FieldPoint from = is_lit_ ? line_[piece_corner_] : came_from_;
    for (;;) {
        const FieldPoint to = is_lit_ ? line_[++piece_corner_] : end_;
        const FieldVector delta = to - from;
        piece_begin_ += piece_length_;
        piece_length_ = delta.length();
        if (distance - piece_begin_ <= piece_length_)
            return piece_.begin(from, delta, piece_length_);
        from = to;
    }
}

}
