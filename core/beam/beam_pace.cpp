#include "core/beam/beam_pace.hpp"

#include <algorithm>
#include <optional>

namespace kfast {
namespace {

class PaceSearch {
public:
    PaceSearch(const BeamLines& lines, std::span<const BeamLeg> legs, const BeamProfile& profile,
               std::uint32_t budget)
        : lines_{lines}, legs_{legs}, profile_{profile}, budget_{budget}
    {
    }

    BeamPace run(int guess)
    {
        find_haste(guess);
        if (!found_)
            find_legs();
        add_pause();
        return *found_;
    }

private:
    /// Less haste never takes fewer points.
    void find_haste(int guess)
    {
        int too_slow = -1;
        int fast_enough = BeamGait::max_haste + 1;
        int stride = 1;
        for (int haste = guess; too_slow + 1 < fast_enough;) {
            if (fits(haste, legs_.size()))
                fast_enough = haste;
            else
                too_slow = haste;
            const bool is_bracketed = too_slow >= 0 && fast_enough <= BeamGait::max_haste;
            haste = is_bracketed ? (too_slow + fast_enough) / 2
                                 : std::clamp(too_slow < 0 ? fast_enough - stride : too_slow + stride, 0,
                                              BeamGait::max_haste);
            stride *= 2;
        }
    }

    void find_legs()
    {
        std::size_t enough = 0;
        std::size_t too_many = legs_.size();
        fits(BeamGait::max_haste, 0);
        while (enough + 1 < too_many) {
            const std::size_t middle = (enough + too_many) / 2;
            (fits(BeamGait::max_haste, middle) ? enough : too_many) = middle;
        }
    }

    /// Whether so many legs find room. What does was found.
    bool fits(int haste, std::size_t legs)
    {
        const std::uint32_t pause = profile_.is_laser ? 1 : 0;
        BeamCourse course{lines_, legs_.first(legs), BeamGait{profile_, haste}, pause};
        BeamAmount amount;
        while (course.next_run()) {
            const std::uint32_t points = course.left();
            if (points > budget_ - amount.points)
                return false;
            amount.points += points;
            amount.lit_points += course.is_lit() ? points : 0;
            (course.is_lit() ? amount.lit_length : amount.blanked_length) += course.length();
        }
        found_ = {.haste = haste, .legs = legs, .pause = pause, .amount = amount};
        return true;
    }

    /// A laser always has a point of it, so that what is longer adds nothing else.
    void add_pause()
    {
        const std::uint32_t min = std::min(profile_.rate / BeamPace::max_refresh, budget_);
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
    std::optional<BeamPace> found_;
};

}

BeamPace find_pace(const BeamLines& lines, std::span<const BeamLeg> legs, const BeamProfile& profile,
                   std::uint32_t budget, int guess)
{
    return PaceSearch{lines, legs, profile, budget}.run(guess);
}

}
