#include "host/art/animation/baked_spots.hpp"

#include "host/program/failure.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <string>
#include <utility>

namespace kfast::art {
namespace {

using scene::Vec2;

struct Sample {
    double time = 0;
    Spots spots;
};

double farthest(const Spots& left, const Spots& right)
{
    double max = 0;
    for (std::size_t i = 0; i < left.list.size(); ++i) {
        const Vec2 apart = left.list[i] - right.list[i];
        max = std::max({max, std::abs(apart.x), std::abs(apart.y)});
    }
    return max;
}

/// The slopes that the line of a coordinate may have from a start.
struct Slopes {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();

    bool holds(double slope) const { return low <= slope && slope <= high; }
    bool narrow(double slope, double slack)
    {
        low = std::max(low, slope - slack);
        high = std::min(high, slope + slack);
        return low <= high;
    }
};

/// The straight lines from a start that pass all samples so far within the tolerance.
class Cone {
public:
    enum class Answer { ends_here, passes, none };

    Cone(const Sample& start, double tolerance) : tolerance_{tolerance}, slopes_(2 * start.spots.list.size())
    {
    }

    /// Returns whether such a line can end exactly at this sample, or at least pass it.
    Answer take(const Sample& start, const Sample& sample)
    {
        const double span = sample.time - start.time;
        bool ends = true;
        bool passes = true;
        const auto narrow = [&](Slopes& slopes, double way) {
            ends = ends && slopes.holds(way / span);
            passes = slopes.narrow(way / span, tolerance_ / span) && passes;
        };
        for (std::size_t i = 0; i < start.spots.list.size(); ++i) {
            const Vec2 way = sample.spots.list[i] - start.spots.list[i];
            narrow(slopes_[2 * i], way.x);
            narrow(slopes_[2 * i + 1], way.y);
        }
        if (!passes)
            return ends ? Answer::ends_here : Answer::none;
        return ends ? Answer::ends_here : Answer::passes;
    }

private:
    double tolerance_;
    std::vector<Slopes> slopes_;
};

/// Takes samples in order, and keeps as keys those that the others lie between.
class StraightKeys {
public:
    StraightKeys(double tolerance, std::size_t max) : tolerance_{tolerance}, max_{max} {}

    void take(Sample sample)
    {
        if (window_.empty())
            cone_ = Cone{sample, tolerance_};
        window_.push_back(std::move(sample));
        advance();
    }

    /// The next sample is jumped to.
    void jump()
    {
        end();
        keys_.back().ease.kind = EaseKind::hold;
        drop_held_copy();
    }

    std::vector<Key<Spots>> finish()
    {
        end();
        // The last value holds anyway.
        if (keys_.size() > 1 && farthest(keys_[keys_.size() - 2].value, keys_.back().value) == 0)
            keys_.pop_back();
        return std::move(keys_);
    }

private:
    /// Looking more than that many samples past the last end that fits costs more than it finds.
    static constexpr std::size_t farthest_look = 64;

    void advance()
    {
        while (next_ < window_.size()) {
            const auto answer = cone_.take(window_.front(), window_[next_]);
            if (answer == Cone::Answer::ends_here)
                end_ = next_;
            if (answer == Cone::Answer::none || next_ - end_ > farthest_look)
                cut();
            else
                ++next_;
        }
    }

    void cut()
    {
        add_key();
        window_.erase(window_.begin(), window_.begin() + static_cast<std::ptrdiff_t>(end_));
        cone_ = Cone{window_.front(), tolerance_};
        next_ = 1;
        end_ = 0;
    }

    void add_key()
    {
        if (keys_.size() == max_)
            throw Failure("what moves takes more than " + std::to_string(max_) +
                          " keys within the tolerance: allow a greater one, or make the animation shorter");
        keys_.push_back({window_.front().time, window_.front().spots, {}});
    }

    void end()
    {
        while (window_.size() > 1) {
            cut();
            advance();
        }
        add_key();
        window_.clear();
        next_ = 1;
        end_ = 0;
    }

    /// A value that is constant until it jumps needs no second key before the jump.
    void drop_held_copy()
    {
        if (keys_.size() < 2)
            return;
        auto& before = keys_[keys_.size() - 2];
        if (before.ease.kind != EaseKind::linear || farthest(before.value, keys_.back().value) > 0)
            return;
        before.ease.kind = EaseKind::hold;
        keys_.pop_back();
    }

    double tolerance_;
    std::size_t max_;
    std::deque<Sample> window_; ///< from the last key on
    std::size_t next_ = 1;      ///< index of the sample that the cone takes next
    std::size_t end_ = 0;       ///< index of the last sample at which the line can end
    Cone cone_{{}, 0};
    std::vector<Key<Spots>> keys_;
};

/// Half of the tolerance may be lost between the samples, half at them: the lines between samples and those
/// between keys differ most at samples.
class Baker {
public:
    Baker(const std::function<Spots(double)>& spots_at, const Baking& baking)
        : spots_at_{spots_at}, baking_{baking}, keys_{baking.tolerance / 2, baking.max_keys}
    {
    }

    Animated<Spots> bake()
    {
        Sample last = sample_at(baking_.from);
        step_ = std::max(0.5, (baking_.to - baking_.from) * static_cast<double>(last.spots.list.size() + 1) /
                                  (1 << 26));
        keys_.take(last);
        for (const double time : critical_times()) {
            const double before = time - Baking::jump;
            if (before > last.time)
                last = go(std::move(last), before);
            last = leap(last, time);
        }
        if (last.time < baking_.to)
            go(std::move(last), baking_.to);
        return Animated<Spots>{keys_.finish()};
    }

private:
    static constexpr int max_halvings = 5;

    Sample sample_at(double time) const { return {time, spots_at_(time)}; }

    std::vector<double> critical_times() const
    {
        std::vector<double> times;
        for (const double time : baking_.critical)
            if (time > baking_.from && time <= baking_.to)
                times.push_back(time);
        std::ranges::sort(times);
        times.erase(std::unique(times.begin(), times.end()), times.end());
        return times;
    }

    Sample go(Sample last, double end)
    {
        const double begin = last.time;
        const auto steps = static_cast<int>(std::ceil((end - begin) / step_));
        for (int i = 1; i <= steps; ++i) {
            Sample next = sample_at(i < steps ? begin + (end - begin) * i / steps : end);
            take_between(last, next, max_halvings);
            keys_.take(next);
            last = std::move(next);
        }
        return last;
    }

    /// Where a curve is smooth, halving a step leaves a quarter of the error, so that what is left is at most
    /// a quarter of the tolerance, and another quarter is in reserve.
    void take_between(const Sample& from, const Sample& to, int halvings)
    {
        const double time = (from.time + to.time) / 2;
        if (!(from.time < time && time < to.time))
            return;
        const Sample middle = sample_at(time);
        const bool bent =
            halvings > 0 && farthest(middle.spots, mixed(from.spots, to.spots, 0.5)) > baking_.tolerance;
        if (bent)
            take_between(from, middle, halvings - 1);
        keys_.take(middle);
        if (bent)
            take_between(middle, to, halvings - 1);
    }

    Sample leap(const Sample& last, double time)
    {
        Sample next = sample_at(time);
        if (farthest(last.spots, next.spots) > baking_.tolerance / 2)
            keys_.jump();
        keys_.take(next);
        return next;
    }

    const std::function<Spots(double)>& spots_at_;
    const Baking& baking_;
    StraightKeys keys_;
    double step_ = 0.5;
};

}

Spots mixed(const Spots& from, const Spots& to, double share)
{
    Spots result;
    result.list.reserve(from.list.size());
    for (std::size_t i = 0; i < from.list.size(); ++i)
        result.list.push_back(from.list[i] + share * (to.list[i] - from.list[i]));
    return result;
}

Animated<Spots> baked_spots(const std::function<Spots(double)>& spots_at, const Baking& baking)
{
    return Baker{spots_at, baking}.bake();
}

}
