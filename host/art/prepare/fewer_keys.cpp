#include "host/art/prepare/fewer_keys.hpp"

#include "host/art/animation/ease.hpp"
#include "host/art/animation/fitted_ease.hpp"
#include "host/art/document/value_distance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <type_traits>
#include <utility>

namespace kfast::art {
namespace {

template <typename Value>
class FewerKeys {
public:
    FewerKeys(std::vector<Key<Value>> keys, double tolerance, const LineEdge& edge, NewEases& eases)
        : keys_{std::move(keys)}, tolerance_{tolerance}, edge_{edge}, eases_{eases}, kinks_(keys_.size())
    {
        for (std::size_t i = 1; i + 1 < keys_.size(); ++i)
            kinks_[i] = kink_at(i);
    }

    std::vector<Key<Value>> found()
    {
        if (is_constant())
            return {{keys_.front().time, keys_.front().value, {}}};
        std::vector<Key<Value>> kept;
        for (std::size_t i = 0; i + 1 < keys_.size();) {
            const Reach reach = farthest_from(i);
            kept.push_back({keys_[i].time, keys_[i].value, reach.ease});
            i = reach.end;
        }
        kept.push_back({keys_.back().time, keys_.back().value, {}});
        return without_still_ends(std::move(kept));
    }

private:
    struct Reach {
        std::size_t end; ///< index of the key at which the transition ends
        Ease ease;
    };

    /// How far a smooth curve must be from two straight lines that meet at a key at an angle: for evenly
    /// spaced chords of a parabola that is an eighth of how far the key is from the middle of its neighbours.
    double kink_at(std::size_t key) const
    {
        if (keys_[key - 1].ease.kind != EaseKind::linear || keys_[key].ease.kind != EaseKind::linear ||
            !same_form(keys_[key - 1].value, keys_[key].value) ||
            !same_form(keys_[key].value, keys_[key + 1].value))
            return 0;
        const double step =
            std::min(keys_[key].time - keys_[key - 1].time, keys_[key + 1].time - keys_[key].time);
        const Value before = value_at(key - 1, keys_[key].time - step);
        const Value behind = value_at(key, keys_[key].time + step);
        return distance(OnWay<Value>{before, behind, 0.5}, {keys_[key].value, keys_[key].value, 0}) / 8;
    }

    Value value_at(std::size_t key, double time) const
    {
        return mixed(keys_[key].value, keys_[key + 1].value, fraction(key, key + 1, time));
    }

    bool is_constant() const
    {
        const Value& first = keys_.front().value;
        for (std::size_t i = 0; i + 1 < keys_.size(); ++i) {
            if (!same_form(first, keys_[i + 1].value))
                return false;
            const ProgressRange range = progress_range(keys_[i].ease);
            for (const double share : {range.low, range.high})
                if (!(distance(way(i, share), {first, first, 0}) <= constant_tolerance()))
                    return false;
        }
        return true;
    }

    /// Where directions are visible, those of all that moves are checked transition by transition.
    double constant_tolerance() const { return edge_.arms.empty() ? tolerance_ : 0; }

    Reach farthest_from(std::size_t begin)
    {
        Reach best{begin + 1, same(begin, begin + 1) ? Ease{} : keys_[begin].ease};
        extend(begin, 2, best, [&](std::size_t end) { return plain(begin, end); });
        extend(begin, std::max(min_fitted(begin), best.end - begin + 1), best,
               [&](std::size_t end) { return fitted(begin, end); });
        return best;
    }

    /// How many transitions a new ease must replace to save bytes: it takes about as many as six keys of a
    /// number, as do those that it makes superfluous. Keys of drawings are larger.
    std::size_t min_fitted(std::size_t begin) const
    {
        constexpr int ease_cost = 6;
        if (std::is_same_v<Value, Drawing>)
            return 2;
        int saved = 0;
        std::size_t end = begin;
        while (end + 1 < keys_.size() && saved <= ease_cost)
            saved += keys_[end++].ease.kind == EaseKind::cubic ? ease_cost : 1;
        return saved > ease_cost ? std::max<std::size_t>(2, end - begin) : keys_.size();
    }

    /// First in steps that double, then by halving what is left between.
    template <typename EaseTo>
    void extend(std::size_t begin, std::size_t step, Reach& best, const EaseTo& ease_to)
    {
        std::size_t failed = keys_.size();
        const auto reaches = [&](std::size_t end) {
            const auto ease = ease_to(end);
            if (ease)
                best = {end, *ease};
            else
                failed = end;
            return ease.has_value();
        };
        if (begin + step >= failed || !reaches(begin + step))
            return;
        for (step *= 2; begin + step < failed; step *= 2)
            if (!reaches(begin + step))
                break;
        while (failed - best.end > 1)
            reaches(best.end + (failed - best.end) / 2);
    }

    bool same(std::size_t left, std::size_t right) const
    {
        return same_form(keys_[left].value, keys_[right].value) &&
               distance(keys_[left].value, keys_[right].value) == 0;
    }

    bool one_form(std::size_t begin, std::size_t end) const
    {
        for (std::size_t i = begin; i < end; ++i)
            if (!same_form(keys_[i].value, keys_[i + 1].value))
                return false;
        return true;
    }

    std::optional<Ease> plain(std::size_t begin, std::size_t end) const
    {
        if (one_form(begin, end))
            for (const Ease& ease : {Ease{}, Ease{EaseKind::hold}})
                if (is_near(begin, end, ease))
                    return ease;
        return std::nullopt;
    }

    std::optional<Ease> fitted(std::size_t begin, std::size_t end)
    {
        if (!one_form(begin, end) || same(begin, end) || jumps(begin, end) || has_kinks(begin, end) ||
            !eases_.take_fit())
            return std::nullopt;
        constexpr std::size_t steps = 24;
        std::array<double, steps + 1> ways{};
        std::size_t key = begin;
        for (std::size_t i = 1; i <= steps; ++i) {
            const double time =
                keys_[begin].time + (keys_[end].time - keys_[begin].time) * static_cast<double>(i) / steps;
            while (key + 1 < end && keys_[key + 1].time <= time)
                ++key;
            ways[i] = nearest_share(keys_[begin].value, keys_[end].value, way(key, share_at(key, time)));
        }
        const auto ease = fitted_ease(ways);
        if (!ease || !is_near(begin, end, *ease) || !eases_.add(*ease))
            return std::nullopt;
        return ease;
    }

    bool has_kinks(std::size_t begin, std::size_t end) const
    {
        return std::any_of(kinks_.begin() + static_cast<std::ptrdiff_t>(begin) + 1,
                           kinks_.begin() + static_cast<std::ptrdiff_t>(end),
                           [&](double kink) { return kink > tolerance_; });
    }

    bool jumps(std::size_t begin, std::size_t end) const
    {
        for (std::size_t i = begin; i < end; ++i)
            if (keys_[i].ease.kind == EaseKind::hold && !same(i, i + 1))
                return true;
        return false;
    }

    /// For times after that of the key, and before that of the next one or, as the limit from below, at it.
    double share_at(std::size_t key, double time) const
    {
        if (keys_[key].ease.kind == EaseKind::hold)
            return 0;
        return share_of_way(keys_[key].ease, fraction(key, key + 1, time));
    }

    double fraction(std::size_t begin, std::size_t end, double time) const
    {
        return (time - keys_[begin].time) / (keys_[end].time - keys_[begin].time);
    }

    OnWay<Value> way(std::size_t key, double share) const
    {
        return {keys_[key].value, keys_[key + 1].value, share};
    }

    bool is_near(std::size_t begin, std::size_t end, const Ease& ease) const
    {
        for (std::size_t key = begin; key < end; ++key) {
            const Stretch stretch{begin, end, key, ease};
            if (!is_near(stretch, keys_[key].time, keys_[key + 1].time, max_halvings))
                return false;
        }
        return true;
    }

    static constexpr int max_halvings = 8;

    /// A new transition from key `begin` to key `end`, where it replaces the one that leaves `key`.
    struct Stretch {
        std::size_t begin;
        std::size_t end;
        std::size_t key;
        const Ease& ease;
    };

    /// Both transitions are within their bend of the straight lines between their values at two times, and
    /// straight lines are farthest apart at one of their ends. So this is proven for all times between.
    bool is_near(const Stretch& at, double from, double to, int halvings) const
    {
        const double apart = std::max(distance_at(at, from), distance_at(at, to));
        if (!(apart <= tolerance_))
            return false;
        const double old_bend = bend(keys_[at.key].ease, at.key, at.key + 1, from, to);
        const double new_bend = bend(at.ease, at.begin, at.end, from, to);
        if (apart + old_bend * length(at.key, at.key + 1, old_bend) +
                    new_bend * length(at.begin, at.end, new_bend) <=
                tolerance_ &&
            arms_are_near(at, from, to, old_bend, new_bend))
            return true;
        const double middle = (from + to) / 2;
        return old_bend + new_bend > 0 && halvings > 0 && is_near(at, from, middle, halvings - 1) &&
               is_near(at, middle, to, halvings - 1);
    }

    bool arms_are_near(const Stretch& at, double from, double to, double old_bend, double new_bend) const
    {
        const double old_from = share_at(at.key, from);
        const double old_to = share_at(at.key, to);
        const double new_from = new_share(at, from);
        const double new_to = new_share(at, to);
        return std::ranges::all_of(edge_.arms, [&](const CornerArm& arm) {
            const auto vector = [&](std::size_t begin, std::size_t end, double first, double last) {
                const scene::Vec2 way = arm.directions[end] - arm.directions[begin];
                return TweenedVector{arm.directions[begin] + first * way, (last - first) * way};
            };
            const TweenedVector before = vector(at.key, at.key + 1, old_from, old_to);
            const TweenedVector now = vector(at.begin, at.end, new_from, new_to);
            const double turn =
                greatest_turn(before, now, 0, 1) +
                stray(old_bend * scene::distance(arm.directions[at.key], arm.directions[at.key + 1]),
                      before) +
                stray(new_bend * scene::distance(arm.directions[at.begin], arm.directions[at.end]), now);
            return edge_.half_width * arm.factor * turn <= edge_.tolerance;
        });
    }

    /// How much a vector may rotate that is off its straight line by at most `off`.
    static double stray(double off, const TweenedVector& vector)
    {
        if (off == 0)
            return 0;
        const double length = shortest(vector, 0, 1);
        return off < length ? std::asin(off / length) : std::numbers::pi;
    }

    /// The bend of the progress from key `begin` to key `end`, between two times.
    double bend(const Ease& ease, std::size_t begin, std::size_t end, double from, double to) const
    {
        return bend_of(ease, fraction(begin, end, from), fraction(begin, end, to));
    }

    /// The length of a transition, if it is needed.
    double length(std::size_t begin, std::size_t end, double bend) const
    {
        return bend > 0 ? distance(keys_[begin].value, keys_[end].value) : 0;
    }

    double new_share(const Stretch& at, double time) const
    {
        return at.ease.kind == EaseKind::hold ? 0 : share_of_way(at.ease, fraction(at.begin, at.end, time));
    }

    double distance_at(const Stretch& at, double time) const
    {
        return distance(way(at.key, share_at(at.key, time)),
                        {keys_[at.begin].value, keys_[at.end].value, new_share(at, time)});
    }

    /// The first value holds before, the last one after.
    static std::vector<Key<Value>> without_still_ends(std::vector<Key<Value>> keys)
    {
        const auto same = [](const Key<Value>& left, const Key<Value>& right) {
            return same_form(left.value, right.value) && distance(left.value, right.value) == 0;
        };
        while (keys.size() > 1 && same(keys[keys.size() - 2], keys.back()))
            keys.pop_back();
        auto first = keys.begin();
        while (std::next(first) != keys.end() && same(*first, *std::next(first)))
            ++first;
        keys.erase(keys.begin(), first);
        keys.back().ease = {};
        return keys;
    }

    std::vector<Key<Value>> keys_;
    double tolerance_;
    const LineEdge& edge_;
    NewEases& eases_;
    std::vector<double> kinks_; ///< by key
};

template <typename Value>
void leave_out(Animated<Value>& animated, double tolerance, const LineEdge& edge, NewEases& eases)
{
    if (!animated.is_still())
        animated.keys = FewerKeys<Value>{std::move(animated.keys), tolerance, edge, eases}.found();
}

}

bool NewEases::add(const Ease& ease)
{
    if (std::ranges::find(list_, ease) != list_.end())
        return true;
    if (list_.size() == max)
        return false;
    list_.push_back(ease);
    return true;
}

void leave_out_keys(Channel& channel, double tolerance, NewEases& eases)
{
    leave_out(channel, tolerance, {}, eases);
}

void leave_out_keys(Animated<Rgb>& colour, double tolerance, NewEases& eases)
{
    leave_out(colour, tolerance, {}, eases);
}

void leave_out_keys(Animated<Drawing>& drawing, double tolerance, NewEases& eases)
{
    leave_out(drawing, tolerance, {}, eases);
}

void leave_out_keys(Animated<Drawing>& drawing, double tolerance, const LineEdge& edge, NewEases& eases)
{
    leave_out(drawing, tolerance, edge, eases);
}

}
