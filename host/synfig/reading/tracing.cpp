#include "host/synfig/reading/tracing.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace kfast::synfig {
namespace {

using art::Drawing;
using art::Ease;
using art::EaseKind;
using art::Rgb;

// How near to a bend values are still those before it, or already those after it.
constexpr double beside = 1.0 / 1024;
constexpr double shortest_way = 1.0 / 8;
// The scene language has laws that overshoot as far as that.
constexpr double lowest_swing = -2;
constexpr double highest_swing = 3;

void append(std::vector<double>& numbers, scene::Vec2 spot)
{
    numbers.push_back(spot.x);
    numbers.push_back(spot.y);
}

std::vector<double> numbers_of(double value) { return {value}; }
std::vector<double> numbers_of(const Rgb& colour) { return {colour.red, colour.green, colour.blue}; }

/// Lines as cubics, so that all drawings of one form have as many.
std::vector<double> numbers_of(const Drawing& drawing)
{
    std::vector<double> numbers;
    for (const scene::Outline& outline : drawing.outlines) {
        append(numbers, outline.from);
        scene::Vec2 from = outline.from;
        for (const scene::Curve& curve : outline.curves) {
            append(numbers, curve.cubic ? curve.c1 : from + 1.0 / 3 * (curve.to - from));
            append(numbers, curve.cubic ? curve.c2 : from + 2.0 / 3 * (curve.to - from));
            append(numbers, curve.to);
            from = curve.to;
        }
    }
    return numbers;
}

template <typename Value>
bool alike(const Value&, const Value&)
{
    return true;
}
bool alike(const Drawing& left, const Drawing& right) { return art::same_form(left, right); }

double largest_difference(const std::vector<double>& left, const std::vector<double>& right)
{
    double largest = 0;
    for (std::size_t i = 0; i < left.size(); ++i)
        largest = std::max(largest, std::abs(left[i] - right[i]));
    return largest;
}

void take(art::Budget& budget, const Drawing& drawing)
{
    for (const scene::Outline& outline : drawing.outlines)
        budget.take_points(outline.curves.size() + 1);
}
template <typename Value>
void take(art::Budget& budget, const Value&)
{
    budget.take_keys(1);
}

/// The cubic ease in time with this progress at a third and at two thirds of the time.
Ease ease_through(double at_third, double at_two_thirds)
{
    const double first = at_third - 1.0 / 27;
    const double second = at_two_thirds - 8.0 / 27;
    return {EaseKind::cubic, 1.0 / 3, 3 * first - 1.5 * second, 2.0 / 3, 3 * second - 1.5 * first};
}

/// A scene holds only some hundred different laws: those that are nearly the same become one, within twice
/// the tolerance.
Ease on_grid(Ease ease, double grid)
{
    ease.y1 = std::round(ease.y1 * grid) / grid;
    ease.y2 = std::round(ease.y2 * grid) / grid;
    return ease;
}

bool within_law(const Ease& ease)
{
    return std::min(ease.y1, ease.y2) >= lowest_swing && std::max(ease.y1, ease.y2) <= highest_swing;
}

template <typename Value>
class Tracer {
public:
    Tracer(const std::function<Value(double)>& value_at, const Tracing& tracing)
        : value_at_{value_at}, tracing_{tracing}
    {
    }

    std::vector<art::Key<Value>> keys()
    {
        const std::vector<double> times = all_bends();
        for (std::size_t i = 0; i + 1 < times.size(); ++i)
            trace_between(times[i], times[i + 1]);
        if (times.size() < 2 || !same(last_, value_at_(times.back())))
            jump_to(times.back());
        else if (keys_.size() > 1 || !keys_.front().ease_is_idle)
            add(times.back(), last_, {}, false);
        return finished();
    }

private:
    struct TracedKey {
        art::Key<Value> key;
        bool ease_is_idle = false; ///< nothing changes until the next key
    };

    std::vector<double> all_bends() const
    {
        std::vector<double> times{tracing_.from};
        for (const double bend : tracing_.bends)
            if (bend > tracing_.from + 2 * beside && bend < tracing_.to - 2 * beside)
                times.push_back(bend);
        if (tracing_.to > tracing_.from)
            times.push_back(tracing_.to);
        std::ranges::sort(times);
        const auto close = [](double a, double b) { return b - a < 3 * beside; };
        times.erase(std::unique(times.begin(), times.end(), close), times.end());
        return times;
    }

    bool same(const Value& left, const Value& right) const
    {
        return alike(left, right) &&
               largest_difference(numbers_of(left), numbers_of(right)) <= tracing_.tolerance;
    }

    /// At its bends a value is already what it becomes, except for its form.
    Value beginning(double from) const
    {
        Value at = value_at_(from);
        Value behind = value_at_(from + beside);
        return alike(at, behind) && largest_difference(numbers_of(at), numbers_of(behind)) < jump_size()
                   ? at
                   : behind;
    }

    Value ending(double to) const
    {
        Value before = value_at_(to - beside);
        Value at = value_at_(to);
        return alike(at, before) && largest_difference(numbers_of(at), numbers_of(before)) < jump_size()
                   ? at
                   : before;
    }

    /// More than anything moves within 1/1024 frame.
    double jump_size() const { return 4 * tracing_.tolerance; }

    void trace_between(double from, double to)
    {
        Value begin = beginning(from);
        if (!keys_.empty() && !same(last_, begin))
            close_before(from);
        const Value end = ending(to);
        divide(from, std::move(begin), to, end);
        last_ = end;
    }

    /// The value jumps at `time`: it stays what it was until then.
    void close_before(double time)
    {
        if (keys_.back().ease_is_idle)
            keys_.back().key.ease = {EaseKind::hold};
        else
            add(time - beside, last_, {EaseKind::hold}, true);
    }

    void jump_to(double time)
    {
        if (!keys_.empty())
            close_before(time);
        add(time, value_at_(time), {}, true);
    }

    void divide(double from, Value begin, double to, const Value& end)
    {
        Ease ease;
        if (fits(from, begin, to, end, ease) || to - from <= shortest_way) {
            add(from, begin, ease, same(begin, end));
            return;
        }
        double middle = std::round((from + to) / 2);
        if (middle <= from || middle >= to)
            middle = (from + to) / 2;
        const Value between = value_at_(middle);
        if (!alike(begin, between)) {
            add(from, begin, {EaseKind::hold}, true);
            divide(middle, between, to, end);
            return;
        }
        divide(from, std::move(begin), middle, between);
        divide(middle, between, to, end);
    }

    bool fits(double from, const Value& begin, double to, const Value& end, Ease& ease) const
    {
        if (!alike(begin, end))
            return false;
        const auto first = numbers_of(begin);
        const auto last = numbers_of(end);
        const double span = to - from;
        std::size_t max = 0;
        for (std::size_t i = 0; i < first.size(); ++i)
            if (std::abs(last[i] - first[i]) > std::abs(last[max] - first[max]))
                max = i;
        const double change = first.empty() ? 0 : last[max] - first[max];
        if (std::abs(change) > tracing_.tolerance / 16) {
            if (follows(from, to, first, last, {}, tracing_.tolerance))
                return true;
            const auto third = numbers_of(value_at_(from + span / 3));
            const auto two_thirds = numbers_of(value_at_(from + 2 * span / 3));
            if (third.size() != first.size() || two_thirds.size() != first.size())
                return false;
            ease = ease_through((third[max] - first[max]) / change, (two_thirds[max] - first[max]) / change);
            if (!within_law(ease)) {
                ease = {};
                return false;
            }
        }
        if (!follows(from, to, first, last, ease, tracing_.tolerance)) {
            ease = {};
            return false;
        }
        for (const double grid : {4.0, 16.0, 64.0})
            if (const Ease rounded = on_grid(ease, grid);
                follows(from, to, first, last, rounded, 2 * tracing_.tolerance)) {
                ease = rounded;
                break;
            }
        return true;
    }

    bool follows(double from, double to, const std::vector<double>& first, const std::vector<double>& last,
                 const Ease& ease, double tolerance) const
    {
        const int samples = std::clamp(static_cast<int>(2 * (to - from)), 5, 96);
        // Beginning in the middle, where a misfit shows first.
        for (int i = 0; i < samples; ++i) {
            const double share = std::fmod(0.5 + 0.618034 * i, 1.0);
            const auto here = numbers_of(value_at_(from + share * (to - from)));
            if (here.size() != first.size())
                return false;
            const double way = art::share_of_way(ease, share);
            for (std::size_t n = 0; n < here.size(); ++n)
                if (!(std::abs(here[n] - art::mixed(first[n], last[n], way)) <= tolerance))
                    return false;
        }
        return true;
    }

    void add(double time, const Value& value, const Ease& ease, bool idle)
    {
        take(*tracing_.budget, value);
        keys_.push_back({{time, value, ease}, idle});
    }

    /// What never changes has one key.
    std::vector<art::Key<Value>> finished() const
    {
        const bool still = std::ranges::all_of(keys_, [&](const TracedKey& key) {
            return key.ease_is_idle && same(key.key.value, keys_[0].key.value);
        });
        std::vector<art::Key<Value>> result;
        for (const TracedKey& key : keys_)
            if (result.empty() || (!still && key.key.time > result.back().time))
                result.push_back(key.key);
        if (still)
            result.front().ease = {};
        return result;
    }

    const std::function<Value(double)>& value_at_;
    const Tracing& tracing_;
    std::vector<TracedKey> keys_;
    Value last_{};
};

template <typename Value>
art::Animated<Value> traced_value(const std::function<Value(double)>& value_at, const Tracing& tracing)
{
    return art::Animated<Value>{Tracer<Value>{value_at, tracing}.keys()};
}

}

art::Channel traced(const std::function<double(double)>& value_at, const Tracing& tracing)
{
    return traced_value(value_at, tracing);
}

art::Animated<Rgb> traced(const std::function<Rgb(double)>& colour_at, const Tracing& tracing)
{
    return traced_value(colour_at, tracing);
}

art::Animated<Drawing> traced(const std::function<Drawing(double)>& drawing_at, const Tracing& tracing)
{
    return traced_value(drawing_at, tracing);
}

}
