#include "host/synfig/reading/clock.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kfast::synfig {
namespace {

constexpr std::size_t max_moments = 20'000;

}

double Driver::seconds(double frame) const
{
    double time = begin_ + frame / frame_rate_;
    for (const Gear& gear : gears_)
        time = gear.inside(time);
    return time;
}

std::vector<double> Driver::frames(double seconds, double last) const
{
    const double end = begin_ + last / frame_rate_;
    std::vector<double> moments{seconds};
    for (std::size_t i = gears_.size(); i-- > 0;) {
        std::vector<double> around;
        for (const double moment : moments)
            for (const double time : gears_[i].around(begin_, end, moment))
                if (around.size() < max_moments)
                    around.push_back(time);
        moments = std::move(around);
    }
    std::vector<double> result;
    for (const double moment : moments) {
        // Times that are frames but for rounding are frames.
        const double frame = std::round((moment - begin_) * frame_rate_ * 65536) / 65536;
        if (frame >= 0 && frame <= last)
            result.push_back(frame);
    }
    return result;
}

Driver Driver::with(Gear gear) const
{
    Driver clock = *this;
    clock.gears_.push_back(std::move(gear));
    return clock;
}

Driver::Gear running_gear(std::function<double(double)> factor, std::function<double(double)> offset)
{
    const auto around = [factor, offset](double from, double, double inside) -> std::vector<double> {
        const double speed = factor(from);
        return speed == 0 ? std::vector<double>{} : std::vector{(inside - offset(from)) / speed};
    };
    return {[factor, offset](double time) { return factor(time) * time + offset(time); }, around};
}

Driver::Gear looping_gear(double inside, double local, double duration, double shift_before)
{
    const double length = std::abs(duration);
    const double direction = duration < 0 ? -1 : 1;
    const auto phase = [=](double time) {
        // Frames are rounded: a loop begins again on its frame, not just before.
        const double turns = std::floor((time - local) / length + 1e-9);
        return std::max(0.0, time - local - turns * length);
    };
    const auto around = [=](double from, double to, double moment) {
        std::vector<double> times;
        const double first = std::floor((from - local) / length);
        const double offset = direction * (moment - inside);
        for (double turn = first; local + turn * length <= to && times.size() < max_moments; ++turn) {
            times.push_back(local + turn * length);
            if (offset > 0 && offset < length)
                times.push_back(local + turn * length + offset);
        }
        return times;
    };
    return {[=](double time) { return inside + direction * phase(time) + (time < local ? shift_before : 0); },
            around};
}

Driver::Gear free_gear(std::function<double(double)> time)
{
    return {std::move(time), [](double, double, double) { return std::vector<double>{}; }};
}

}
