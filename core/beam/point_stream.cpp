#include "core/beam/point_stream.hpp"

#include <algorithm>
#include <optional>

namespace kfast {

namespace {

class TimingSearch {
public:
    TimingSearch(const BeamLines& lines, std::span<const BeamLeg> legs, const BeamProfile& profile,
                 std::uint32_t budget)
        : lines_{lines}, legs_{legs}, profile_{profile}, budget_{budget}
    {
    }

    BeamTiming run(int guess)
    {
        find_speed_level(guess);
        if (!found_)
            find_legs();
        add_pause();
        return *found_;
    }

private:
    /// A lower speed level never takes fewer points.
    void find_speed_level(int guess)
    {
        int too_slow = -1;
        int fast_enough = StepProfile::max_speed_level + 1;
        int stride = 1;
        for (int speed_level = guess; too_slow + 1 < fast_enough;) {
            if (fits(speed_level, legs_.size()))
                fast_enough = speed_level;
            else
                too_slow = speed_level;
            const bool is_bracketed = too_slow >= 0 && fast_enough <= StepProfile::max_speed_level;
            speed_level = is_bracketed ? (too_slow + fast_enough) / 2
                                       : std::clamp(too_slow < 0 ? fast_enough - stride : too_slow + stride,
                                                    0, StepProfile::max_speed_level);
            stride *= 2;
        }
    }

    void find_legs()
    {
        std::size_t enough = 0;
        std::size_t too_many = legs_.size();
        fits(StepProfile::max_speed_level, 0);
        while (enough + 1 < too_many) {
            const std::size_t middle = (enough + too_many) / 2;
            (fits(StepProfile::max_speed_level, middle) ? enough : too_many) = middle;
        }
    }

    /// Whether that many legs find room. The result is kept if they do.
    bool fits(int speed_level, std::size_t legs)
    {
        const std::uint32_t pause = profile_.is_laser ? 1 : 0;
        PointSequencer sequencer{lines_, legs_.first(legs), StepProfile{profile_, speed_level}, pause};
        BeamAmount amount;
        while (sequencer.next_run()) {
            const std::uint32_t points = sequencer.left();
            if (points > budget_ - amount.points)
                return false;
            amount.points += points;
            amount.lit_points += sequencer.is_lit() ? points : 0;
            (sequencer.is_lit() ? amount.lit_length : amount.blanked_length) += sequencer.length();
        }
        found_ = {.speed_level = speed_level, .legs = legs, .pause = pause, .amount = amount};
        return true;
    }

    /// A laser always has a point of it, so that what is longer adds nothing else.
    void add_pause()
    {
        const std::uint32_t min = std::min(profile_.rate / BeamTiming::max_refresh, budget_);
        BeamAmount& amount = found_->amount;
        if (found_->pause == 0 || found_->legs == 0 || amount.points >= min)
            return;
        found_->pause += min - amount.points;
        amount.points = min;
    }

    const BeamLines& lines_;
    std::span<const BeamLeg> legs_;
    const BeamProfile& profile_;
    std::uint32_t budget_;
    std::optional<BeamTiming> found_;
};

}

BeamTiming find_timing(const BeamLines& lines, std::span<const BeamLeg> legs, const BeamProfile& profile,
                       std::uint32_t budget, int guess)
{
    return TimingSearch{lines, legs, profile, budget}.run(guess);
}

namespace {

constexpr Colour blanked{.opacity = 0};
constexpr Colour whole_light{255, 255, 255, 255};

}

PointStream::PointStream(const BeamLines& lines, std::span<const BeamLeg> legs, const BeamProfile& profile,
                         const BeamTiming& timing)
    : sequencer_{lines, legs.first(timing.legs), StepProfile{profile, timing.speed_level}, timing.pause},
      places_{sequencer_},
      standing_{profile, timing.amount.points},
      is_late_{profile.light_delay != 0},
      is_laser_{profile.is_laser},
      brightness_{profile.brightness}
{
    for (int ahead = 0; ahead < profile.light_delay; ++ahead)
        next_place();
}

std::size_t PointStream::next(std::span<BeamPoint> points)
{
    std::size_t count = 0;
    while (count < points.size() && (sequencer_.left() != 0 || sequencer_.next_run())) {
        const std::size_t run = std::min<std::size_t>(points.size() - count, sequencer_.left());
        plot_run(points.subspan(count, run));
        count += run;
    }
    return count;
}

void PointStream::plot_run(std::span<BeamPoint> points)
{
    const bool is_guarded = is_laser_ && sequencer_.is_lit();
    const Colour colour = light();
    for (BeamPoint& point : points) {
        const FieldPoint at = sequencer_.next();
        point.at = is_late_ ? next_place() : at;
        point.colour = colour;
        if (is_guarded && !standing_.may_shine(at))
            point.colour = blanked;
    }
}

FieldPoint PointStream::next_place()
{
    while (places_.left() == 0 && !places_.next_run())
        places_.restart();
    return places_.next();
}

Colour PointStream::light() const
{
    if (!sequencer_.is_lit())
        return blanked;
    return brightness_ == BeamBrightness::by_level ? sequencer_.colour() : whole_light;
}

}
