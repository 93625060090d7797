#include "host/lottie/drawings/moving_drawing.hpp"

#include "host/art/animation/baked_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

namespace kfast::lottie {

void Moments::add(const Moments& others)
{
    for (const auto& [time, other] : others.list_) {
        Moment& moment = list_[time];
        for (const art::Ease& ease : other.eases)
            add(moment, ease);
        moment.jump = moment.jump || other.jump;
    }
}

void Moments::add(Moment& moment, const art::Ease& ease)
{
    // Beyond a few, none governs everything: it is baked.
    constexpr std::size_t max_tried = 4;
    if (moment.eases.size() < max_tried && std::ranges::find(moment.eases, ease) == moment.eases.end())
        moment.eases.push_back(ease);
}

namespace {

std::size_t point_count(const art::Drawing& drawing)
{
    std::size_t count = 1;
    for (const scene::Outline& outline : drawing.outlines)
        count += outline.curves.size() + 1;
    return count;
}

}

MovingDrawing moving(art::Animated<art::Drawing> drawing)
{
    MovingDrawing result;
    result.moments.add(drawing);
    const auto shared = std::make_shared<const art::Animated<art::Drawing>>(std::move(drawing));
    for (const auto& key : shared->keys) {
        result.changes_form = result.changes_form || !art::same_form(key.value, shared->keys.front().value);
        result.points = std::max(result.points, static_cast<double>(point_count(key.value)));
    }
    result.cost = result.points;
    result.at = [shared](double time) { return shared->at(time); };
    return result;
}

MovingDrawing together(std::vector<MovingDrawing> drawings)
{
    if (drawings.size() == 1)
        return std::move(drawings.front());
    MovingDrawing result;
    for (const MovingDrawing& drawing : drawings) {
        result.moments.add(drawing.moments);
        result.changes_form = result.changes_form || drawing.changes_form;
        result.points += drawing.points;
        result.cost += drawing.cost;
    }
    const auto parts = std::make_shared<const std::vector<MovingDrawing>>(std::move(drawings));
    result.at = [parts](double time) {
        art::Drawing all;
        for (const MovingDrawing& part : *parts) {
            art::Drawing drawing = part.at(time);
            std::ranges::move(drawing.outlines, std::back_inserter(all.outlines));
        }
        return all;
    };
    return result;
}

namespace {

using art::Drawing;
using scene::Curve;
using scene::Outline;
using scene::Vec2;

double apart(Vec2 left_from, const Curve& left, Vec2 right_from, const Curve& right)
{
    if (!left.cubic && !right.cubic)
        return scene::distance(left.to, right.to);
    const Curve one = art::as_cubic(left_from, left);
    const Curve other = art::as_cubic(right_from, right);
    return std::max({scene::distance(one.c1, other.c1), scene::distance(one.c2, other.c2),
                     scene::distance(one.to, other.to)});
}

bool are_near(const Outline& left, const Outline& right, double tolerance)
{
    if (scene::distance(left.from, right.from) > tolerance)
        return false;
    Vec2 left_from = left.from;
    Vec2 right_from = right.from;
    for (std::size_t i = 0; i < left.curves.size(); ++i) {
        if (apart(left_from, left.curves[i], right_from, right.curves[i]) > tolerance)
            return false;
        left_from = left.curves[i].to;
        right_from = right.curves[i].to;
    }
    return true;
}

bool are_near(const Drawing& left, const Drawing& right, double tolerance)
{
    return art::same_form(left, right) &&
           std::ranges::equal(left.outlines, right.outlines, [&](const Outline& one, const Outline& other) {
               return are_near(one, other, tolerance);
           });
}

class KeyFitter {
public:
    KeyFitter(const MovingDrawing& drawing, art::Budget& budget) : drawing_{drawing}, budget_{budget} {}

    art::Animated<Drawing> keys()
    {
        const auto& moments = drawing_.moments.list();
        if (moments.empty()) {
            add({0, computed(0), {}});
            return art::Animated<Drawing>{std::move(keys_)};
        }
        for (auto next = std::next(moments.begin()); next != moments.end(); ++next)
            go(*std::prev(next), next->first);
        bake_until(moments.rbegin()->first);
        add({moments.rbegin()->first, computed(moments.rbegin()->first), {}});
        return art::Animated<Drawing>{std::move(keys_)};
    }

private:
    static constexpr double exact = 1.0 / 1024;

    Drawing computed(double time) const
    {
        constexpr double beyond_all = 1e12;
        budget_.take_computed_points(static_cast<std::size_t>(std::min(drawing_.cost, beyond_all)));
        return drawing_.at(time);
    }

    void add(art::Key<Drawing> key)
    {
        if (!keys_.empty() && keys_.back().time >= key.time)
            keys_.pop_back();
        budget_.take_points(point_count(key.value));
        keys_.push_back(std::move(key));
    }

    void go(const std::pair<const double, Moment>& moment, double to)
    {
        const std::optional<art::Ease> ease = ease_between(moment, to);
        if (!ease) {
            bake_from_ = bake_from_.value_or(moment.first);
            return;
        }
        bake_until(moment.first);
        add({moment.first, computed(moment.first), *ease});
    }

    /// Where to sample whether an ease fits a transition of that many frames. What may change its form at any
    /// time may do so in between, and back soon after.
    std::vector<double> looks(double frames) const
    {
        std::vector<double> shares{0.37, 0.87, 0.13, 0.61};
        constexpr double looks_per_frame = 4;
        constexpr double max_looks = 1024;
        const double count =
            drawing_.changes_form ? std::min(max_looks, std::ceil(looks_per_frame * frames)) : 0;
        for (double i = 1; i < count; ++i)
            shares.push_back(i / count);
        return shares;
    }

    /// The one that fits the whole transition, if one does.
    std::optional<art::Ease> ease_between(const std::pair<const double, Moment>& moment, double to) const
    {
        std::vector<art::Ease> eases = moment.second.eases;
        eases.push_back({});
        eases.push_back({.kind = art::EaseKind::hold});
        const double from = moment.first;
        const Drawing begin = computed(from);
        const Drawing end = computed(to);
        const bool one_form = art::same_form(begin, end);
        for (const double share : looks(to - from)) {
            const Drawing drawing = computed(from + share * (to - from));
            std::erase_if(eases, [&](const art::Ease& ease) {
                if (!one_form && ease.kind != art::EaseKind::hold)
                    return true;
                return !are_near(drawing, art::mixed(begin, end, art::share_of_way(ease, share)), exact);
            });
            if (eases.empty())
                return std::nullopt;
        }
        return eases.front();
    }

    void bake_until(double to)
    {
        if (!bake_from_)
            return;
        double from = *bake_from_;
        bake_from_.reset();
        if (drawing_.changes_form)
            while (const auto change = form_change(from, to)) {
                bake(from, std::max(from, *change - art::Baking::jump));
                keys_.back().ease = {.kind = art::EaseKind::hold};
                from = *change;
            }
        bake(from, to);
    }

    /// When the drawing first has another form than at `from`, to 1/1024 frame.
    std::optional<double> form_change(double from, double to) const
    {
        const Drawing form = computed(from);
        const double step = std::max(0.25, (to - from) * static_cast<double>(point_count(form)) / (1 << 20));
        const auto changed = [&](double time) { return !art::same_form(computed(time), form); };
        double same = from;
        while (same < to) {
            double other = std::min(same + step, to);
            if (changed(other)) {
                while (other - same > art::Baking::jump) {
                    const double middle = (same + other) / 2;
                    if (!(same < middle && middle < other))
                        break; // such large times have no finer steps
                    (changed(middle) ? other : same) = middle;
                }
                return other;
            }
            same = other;
        }
        return std::nullopt;
    }

    /// Adds keys of one form; one at `to` as well, unless nothing changes.
    void bake(double from, double to)
    {
        Drawing last = computed(from);
        if (to - from < 2 * art::Baking::jump)
            return add({from, std::move(last), {}});
        // A form that lasts less than the step of form_change() is skipped.
        const auto at = [&](double time) {
            Drawing drawing = computed(time);
            if (art::same_form(drawing, last))
                last = std::move(drawing);
            return last;
        };
        art::Baking baking{.from = from, .to = to, .critical = {}, .tolerance = baked_tolerance};
        for (auto moment = drawing_.moments.list().lower_bound(from);
             moment != drawing_.moments.list().end() && moment->first <= to; ++moment)
            baking.critical.push_back(moment->first);
        for (auto& key : art::baked_drawing(at, baking).keys)
            add(std::move(key));
    }

    const MovingDrawing& drawing_;
    art::Budget& budget_;
    std::optional<double> bake_from_;
    std::vector<art::Key<Drawing>> keys_;
};

}

art::Animated<art::Drawing> keys_of(const MovingDrawing& drawing, art::Budget& budget)
{
    return KeyFitter{drawing, budget}.keys();
}

}
