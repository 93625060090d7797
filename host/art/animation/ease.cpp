#include "host/art/animation/ease.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace kfast::art {

namespace {

/// The value of a cubic Bézier from 0 to 1.
double cubic(double first, double second, double parameter)
{
    const double rest = 1 - parameter;
    return 3 * rest * rest * parameter * first + 3 * rest * parameter * parameter * second +
           parameter * parameter * parameter;
}

double slope(double first, double second, double parameter)
{
    const double rest = 1 - parameter;
    return 3 * (rest * rest * first + 2 * rest * parameter * (second - first) +
                parameter * parameter * (1 - second));
}

}

double share_of_way(const Ease& ease, double time)
{
    if (time >= 1)
        return 1;
    if (time <= 0 || ease.kind == EaseKind::hold)
        return 0;
    if (ease.kind == EaseKind::linear)
        return time;
    return cubic(ease.y1, ease.y2, parameter_at(ease, time));
}

double parameter_at(const Ease& ease, double time)
{
    // x rises with the parameter, for x1 and x2 are 0 to 1. Newton's steps, or bisection where those diverge.
    constexpr int max_steps = 60;
    constexpr double near_enough = 1e-15;
    double low = 0;
    double high = 1;
    double parameter = time;
    for (int step = 0; step < max_steps; ++step) {
        const double miss = cubic(ease.x1, ease.x2, parameter) - time;
        if (std::abs(miss) <= near_enough)
            break;
        (miss < 0 ? low : high) = parameter;
        const double next = parameter - miss / slope(ease.x1, ease.x2, parameter);
        parameter = low < next && next < high ? next : (low + high) / 2;
    }
    return parameter;
}

namespace {

/// One coordinate of a cubic Bézier: its four control values.
using Values = std::array<double, 4>;

/// The control values of the piece of the cubic between two parameters: its polar form.
Values piece(const Values& whole, double from, double to)
{
    const auto polar = [&](double first, double second, double third) {
        Values at = whole;
        const std::array parameters{first, second, third};
        for (std::size_t round = 0; round < 3; ++round)
            for (std::size_t i = 0; i + round < 3; ++i)
                at[i] += parameters[round] * (at[i + 1] - at[i]);
        return at[0];
    };
    return {polar(from, from, from), polar(from, from, to), polar(from, to, to), polar(to, to, to)};
}

/// The parameters strictly between `from` and `to` where a parabola a s² + b s + c crosses zero.
std::vector<double> roots(double a, double b, double c, double from, double to)
{
    std::vector<double> found;
    const auto keep = [&](double root) {
        if (root > from && root < to)
            found.push_back(root);
    };
    const double square = b * b - 4 * a * c;
    if (square < 0)
        return found;
    // The form without cancellation.
    const double q = -0.5 * (b + std::copysign(std::sqrt(square), b));
    if (a != 0)
        keep(q / a);
    if (q != 0)
        keep(c / q);
    std::ranges::sort(found);
    return found;
}

std::vector<double> extremes(const Values& y, double from, double to)
{
    const double d0 = y[1] - y[0];
    const double d1 = y[2] - y[1];
    const double d2 = y[3] - y[2];
    return roots(d0 - 2 * d1 + d2, 2 * (d1 - d0), d0, from, to);
}

std::vector<double> bends(const Values& x, double from, double to)
{
    return roots(0, x[3] - 3 * x[2] + 3 * x[1] - x[0], x[2] - 2 * x[1] + x[0], from, to);
}

bool within(double value, double low, double high) { return value >= low && value <= high; }

/// Divides a cubic until each piece is a cubic ease between its ends.
class Parts {
public:
    explicit Parts(const Ease& ease) : x_{0, ease.x1, ease.x2, 1}, y_{0, ease.y1, ease.y2, 1} {}

    std::vector<EasePart> between(double from, double to)
    {
        add(from, to);
        return std::move(parts_);
    }

private:
    static constexpr double no_time = 1e-9;
    static constexpr double no_way = 1e-9;
    static constexpr double rounding = 1e-6;

    void add(double from, double to)
    {
        const Values x = piece(x_, from, to);
        const Values y = piece(y_, from, to);
        if (!(x[3] - x[0] > no_time))
            return take_instant(y[3]);
        if (divided(bends(x_, from, to), from, to, !is_time(x)) ||
            divided(extremes(y_, from, to), from, to, !is_way(y)))
            return;
        parts_.push_back({x[0], x[3], y[0], y[3], ease_of(x, y)});
    }

    /// A piece that takes no time, where x does not change, is a jump: it goes to its neighbour.
    void take_instant(double way)
    {
        if (!parts_.empty())
            parts_.back().way_to = way;
    }

    bool divided(const std::vector<double>& at, double from, double to, bool needed)
    {
        if (!needed || at.empty())
            return false;
        double begin = from;
        for (const double end : at) {
            add(begin, end);
            begin = end;
        }
        add(begin, to);
        return true;
    }

    /// Between its inflections the speed of x only falls or only rises, and then this holds.
    static bool is_time(const Values& x)
    {
        const double span = x[3] - x[0];
        return within((x[1] - x[0]) / span, -rounding, 1 + rounding) &&
               within((x[2] - x[0]) / span, -rounding, 1 + rounding);
    }

    /// Between its extremes a cubic rises or falls, and then this holds.
    static bool is_way(const Values& y)
    {
        const double way = y[3] - y[0];
        const double max = highest_y * std::abs(way) + no_way;
        const double middle = 0.5 * (y[3] + y[0]);
        return std::abs(y[1] - middle) <= max && std::abs(y[2] - middle) <= max;
    }

    static Ease ease_of(const Values& x, const Values& y)
    {
        const double span = x[3] - x[0];
        const double way = y[3] - y[0];
        if (std::abs(way) <= no_way)
            return {};
        return {EaseKind::cubic, std::clamp((x[1] - x[0]) / span, 0.0, 1.0), (y[1] - y[0]) / way,
                std::clamp((x[2] - x[0]) / span, 0.0, 1.0), (y[2] - y[0]) / way};
    }

    Values x_;
    Values y_;
    std::vector<EasePart> parts_;
};

}

std::vector<EasePart> ease_parts(const Ease& ease, double from, double to)
{
    if (from <= 0 && to >= 1)
        return {{0, 1, 0, 1, ease}};
    if (ease.kind == EaseKind::linear)
        return {{from, to, from, to, ease}};
    if (ease.kind == EaseKind::hold)
        return {{from, to, 0, to < 1 ? 0.0 : 1.0, ease}};
    std::vector<EasePart> parts = Parts{ease}.between(parameter_at(ease, from), parameter_at(ease, to));
    if (parts.empty())
        return {{from, to, share_of_way(ease, from), share_of_way(ease, to), {}}};
    parts.front().from = from;
    parts.back().to = to;
    return parts;
}

double bend_of(const Ease& ease, double from, double to)
{
    if (ease.kind != EaseKind::cubic)
        return 0;
    const double begin = parameter_at(ease, from);
    const double end = parameter_at(ease, to);
    const Values x = piece({0, ease.x1, ease.x2, 1}, begin, end);
    const Values y = piece({0, ease.y1, ease.y2, 1}, begin, end);
    const double slope = x[3] > x[0] ? (y[3] - y[0]) / (x[3] - x[0]) : 0;
    const auto off = [&](std::size_t i) { return std::abs(y[i] - y[0] - slope * (x[i] - x[0])); };
    // The distance from the line is a Bézier itself: 0 at its ends, and the inner two weigh at most 3/4.
    return 0.75 * std::max(off(1), off(2));
}

ProgressRange progress_range(const Ease& ease)
{
    if (ease.kind != EaseKind::cubic)
        return {};
    return {std::min({0.0, ease.y1, ease.y2}), std::max({1.0, ease.y1, ease.y2})};
}

Ease reversed(const Ease& ease)
{
    if (ease.kind != EaseKind::cubic)
        return ease;
    return {EaseKind::cubic, 1 - ease.x2, 1 - ease.y2, 1 - ease.x1, 1 - ease.y1};
}

}
