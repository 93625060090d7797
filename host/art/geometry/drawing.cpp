#include "host/art/geometry/drawing.hpp"

#include "host/art/geometry/curves.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <utility>

namespace kfast::art {

namespace {

using scene::Curve;
using scene::Outline;
using scene::Vec2;

bool equal(Vec2 left, Vec2 right) { return left.x == right.x && left.y == right.y; }

bool equal(const Curve& left, const Curve& right)
{
    return left.cubic == right.cubic && equal(left.to, right.to) &&
           (!left.cubic || (equal(left.c1, right.c1) && equal(left.c2, right.c2)));
}

bool equal(const Outline& left, const Outline& right)
{
    return left.closed == right.closed && equal(left.from, right.from) &&
           std::ranges::equal(left.curves, right.curves,
                              [](const Curve& one, const Curve& other) { return equal(one, other); });
}

Vec2 mixed(Vec2 from, Vec2 to, double share) { return from + share * (to - from); }

Curve mixed(const Curve& from, const Curve& to, double share)
{
    return {from.cubic, mixed(from.c1, to.c1, share), mixed(from.c2, to.c2, share),
            mixed(from.to, to.to, share)};
}

Outline mixed(const Outline& from, const Outline& to, double share)
{
    Outline result{mixed(from.from, to.from, share), {}, from.closed && to.closed};
    Vec2 begin = from.from;
    Vec2 end = to.from;
    for (std::size_t i = 0; i < from.curves.size(); ++i) {
        const bool lines = !from.curves[i].cubic && !to.curves[i].cubic;
        result.curves.push_back(
            lines ? mixed(from.curves[i], to.curves[i], share)
                  : mixed(as_cubic(begin, from.curves[i]), as_cubic(end, to.curves[i]), share));
        begin = from.curves[i].to;
        end = to.curves[i].to;
    }
    return result;
}

}

Curve as_cubic(Vec2 from, const Curve& curve)
{
    if (curve.cubic)
        return curve;
    return scene::cubic_to(mixed(from, curve.to, 1.0 / 3), mixed(from, curve.to, 2.0 / 3), curve.to);
}

bool operator==(const Drawing& left, const Drawing& right)
{
    return std::ranges::equal(left.outlines, right.outlines,
                              [](const Outline& one, const Outline& other) { return equal(one, other); });
}

bool same_form(const Drawing& left, const Drawing& right)
{
    return std::ranges::equal(left.outlines, right.outlines, [](const Outline& one, const Outline& other) {
        return one.closed == other.closed && one.curves.size() == other.curves.size();
    });
}

Drawing mixed(const Drawing& from, const Drawing& to, double share)
{
    if (!same_form(from, to))
        return share < 1 ? from : to;
    Drawing result;
    for (std::size_t i = 0; i < from.outlines.size(); ++i)
        result.outlines.push_back(mixed(from.outlines[i], to.outlines[i], share));
    return result;
}

namespace {

Vec2 between(Vec2 a, Vec2 b, double share) { return a + share * (b - a); }

/// The polar form of a cubic Bézier: the control points of its subsegments are values of it.
Vec2 blossom(Vec2 from, const Curve& curve, double r, double s, double t)
{
    const Vec2 first = between(from, curve.c1, r);
    const Vec2 second = between(curve.c1, curve.c2, r);
    const Vec2 third = between(curve.c2, curve.to, r);
    return between(between(first, second, s), between(second, third, s), t);
}

/// The subsegment of a curve from the parameter `begin` to `end`.
Curve stretch(Vec2 from, const Curve& curve, double begin, double end)
{
    if (!curve.cubic)
        return scene::line_to(between(from, curve.to, end));
    return scene::cubic_to(blossom(from, curve, begin, begin, end), blossom(from, curve, begin, end, end),
                           spot_on(from, curve, end));
}

/// The current position in the dash pattern.
class Rhythm {
public:
    /// Their sum is above 0.
    Rhythm(std::span<const double> pattern, double offset) : pattern_{pattern}
    {
        const double sum = std::accumulate(pattern.begin(), pattern.end(), 0.0);
        const double period = pattern.size() % 2 == 0 ? sum : 2 * sum;
        double rest = std::fmod(offset, period);
        if (rest < 0)
            rest += period;
        while (rest >= length() && rest > 0) {
            rest -= length();
            step();
        }
        left_ = std::max(0.0, length() - rest);
    }

    bool is_drawn() const { return index_ % 2 == 0; }
    double left() const { return left_; }
    void go(double distance) { left_ -= distance; }
    void next()
    {
        step();
        left_ = length();
    }

private:
    double length() const { return pattern_[index_ % pattern_.size()]; }
    void step() { index_ = (index_ + 1) % (2 * pattern_.size()); }

    std::span<const double> pattern_;
    std::size_t index_ = 0;
    double left_ = 0;
};

/// In pixels. A dash that ends or begins at a corner goes around it by less, as sums of lengths are rounded.
constexpr double shortest = 1e-6;

/// Dashes one outline.
class Dasher {
public:
    Dasher(const Rhythm& rhythm, Budget& budget, Drawing& result)
        : rhythm_{rhythm}, budget_{budget}, result_{result}, first_{result.outlines.size()}
    {
    }

    void run(const Outline& outline)
    {
        begins_drawn_ = rhythm_.is_drawn();
        Vec2 from = outline.from;
        for (const Curve& curve : outline.curves) {
            cut(from, curve);
            from = curve.to;
        }
        if (outline.closed && scene::distance(from, outline.from) > 0)
            cut(from, scene::line_to(outline.from));
        if (!outline.closed || !dash_ || !begins_drawn_)
            end_dash(nullptr);
        else if (has_gaps_)
            end_dash(&result_.outlines[first_]);
        else
            result_.outlines.push_back(outline);
    }

private:
    void cut(Vec2 from, const Curve& curve)
    {
        const double whole = curve_length(from, curve);
        double gone = 0;
        while (gone + rhythm_.left() < whole) {
            const double end = gone + rhythm_.left();
            draw(from, curve, gone, end);
            end_dash(nullptr);
            has_gaps_ = true;
            gone = end;
            rhythm_.next();
        }
        draw(from, curve, gone, whole);
        rhythm_.go(whole - gone);
    }

    void draw(Vec2 from, const Curve& curve, double begin, double end)
    {
        if (!rhythm_.is_drawn()) {
            budget_.take_points(1); // gaps cost time
            return;
        }
        budget_.take_points(2);
        const double first = curve_parameter(from, curve, begin);
        if (!dash_)
            dash_ = Outline{spot_on(from, curve, first), {}, false};
        if (end - begin > shortest)
            dash_->curves.push_back(stretch(from, curve, first, curve_parameter(from, curve, end)));
    }

    /// The dash that continues into `first`, if there is one, replaces it.
    void end_dash(Outline* first)
    {
        if (!dash_)
            return;
        dash_->closed = dash_->curves.empty();
        if (first != nullptr) {
            dash_->curves.insert(dash_->curves.end(), first->curves.begin(), first->curves.end());
            *first = std::move(*dash_);
        } else {
            result_.outlines.push_back(std::move(*dash_));
        }
        dash_.reset();
    }

    Rhythm rhythm_;
    Budget& budget_;
    Drawing& result_;
    std::size_t first_;
    std::optional<Outline> dash_;
    bool begins_drawn_ = false;
    bool has_gaps_ = false;
};

}

Drawing dashed(const Drawing& drawing, std::span<const double> pattern, double offset, Budget& budget)
{
    if (std::ranges::none_of(pattern, [](double length) { return length > 0; }))
        return drawing;
    Drawing result;
    for (const Outline& outline : drawing.outlines)
        Dasher{Rhythm{pattern, offset}, budget, result}.run(outline);
    return result;
}

}
