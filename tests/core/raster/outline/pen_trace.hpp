#pragma once

#include "core/raster/outline/stroke_outline.hpp"
#include "tests/core/spot.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace kfast::test {

/// What a pen covers on its way through some points, by the geometry of rectangles, wedges and caps.
class PenTrace {
public:
    PenTrace(const std::vector<Point>& points, const Pen& pen, bool is_closed)
        : pen_{pen}, half_width_{pen.half_width.raw() / 65536.0}, is_closed_{is_closed}
    {
        for (const Point& point : points)
            points_.push_back(spot(point));
        if (is_closed && apart(points.back(), points_.front()) > 0)
            points_.push_back(points_.front());
    }

    /// Whether `at` is covered by a pen that is `grown` px larger all around.
    bool covers(Spot at, double grown) const
    {
        for (std::size_t i = 1; i < points_.size(); ++i)
            if (in_rectangle(at, points_[i - 1], points_[i], grown))
                return true;
        for (std::size_t i = 2; i < points_.size(); ++i)
            if (in_join(at, points_[i - 2], points_[i - 1], points_[i], grown))
                return true;
        if (is_closed_ && points_.size() > 2)
            return in_join(at, points_[points_.size() - 2], points_[0], points_[1], grown);
        return in_cap(at, points_[0], points_[1], grown) ||
               in_cap(at, points_.back(), points_[points_.size() - 2], grown);
    }

private:
    static double dot(Spot a, Spot b) { return a.x * b.x + a.y * b.y; }
    static double cross(Spot a, Spot b) { return a.x * b.y - a.y * b.x; }
    static Spot unit(Spot a) { return 1 / std::hypot(a.x, a.y) * a; }
    static Spot right_of(Spot a) { return {-a.y, a.x}; }

    bool in_rectangle(Spot at, Spot from, Spot to, double grown) const
    {
        const Spot along = unit(to - from);
        const double ahead = dot(at - from, along);
        return ahead >= -grown && ahead <= dot(to - from, along) + grown &&
               std::abs(cross(along, at - from)) <= half_width_ + grown;
    }

    bool in_join(Spot at, Spot before, Spot corner, Spot after, double grown) const
    {
        const Spot in = unit(corner - before);
        const Spot out = unit(after - corner);
        const double sense = cross(in, out) >= 0 ? -1 : 1; // the outer side is to the left of a right turn
        const Spot first = sense * right_of(in);
        const Spot last = sense * right_of(out);
        const Spot away = at - corner;
        if (dot(away, in) < -grown || dot(away, out) > grown)
            return false;
        if (pen_.join == Join::round)
            return std::hypot(away.x, away.y) <= half_width_ + grown;
        const double half_cosine = std::sqrt(std::max(0.0, (1 + dot(in, out)) / 2));
        if (pen_.join == Join::miter && half_cosine * pen_.miter_limit >= 8)
            return dot(away, first) <= half_width_ + grown && dot(away, last) <= half_width_ + grown;
        return half_cosine > 1e-3 && dot(away, unit(first + last)) <= half_width_ * half_cosine + grown;
    }

    bool in_cap(Spot at, Spot end, Spot inside, double grown) const
    {
        const Spot outwards = unit(end - inside);
        const Spot away = at - end;
        const double ahead = dot(away, outwards);
        if (pen_.cap == Cap::butt || ahead < -grown)
            return false;
        if (pen_.cap == Cap::round)
            return std::hypot(away.x, away.y) <= half_width_ + grown;
        return ahead <= half_width_ + grown && std::abs(cross(outwards, away)) <= half_width_ + grown;
    }

    Pen pen_;
    double half_width_;
    bool is_closed_;
    std::vector<Spot> points_;
};

}
