#include "host/synfig/evaluation/spline_list.hpp"

#include "host/art/animation/animated.hpp"
#include "host/synfig/values/value_node.hpp"

#include <cmath>
#include <numbers>
#include <optional>

namespace kfast::synfig {
namespace {

using art::mixed;

Vec2 mixed(Vec2 from, Vec2 to, double share) { return from + share * (to - from); }

/// Interpolates direction and length from one to the other.
Vec2 swung(Vec2 from, Vec2 to, double share)
{
    const double first = std::sqrt(scene::dot(from, from));
    const double second = std::sqrt(scene::dot(to, to));
    if (first == 0 || second == 0)
        return mixed(from, to, share);
    const double angle = std::atan2(scene::cross(from, to), scene::dot(from, to)) * share;
    const double scale_factor = art::mixed(first, second, share) / first;
    return {scale_factor * (std::cos(angle) * from.x - std::sin(angle) * from.y),
            scale_factor * (std::sin(angle) * from.x + std::cos(angle) * from.y)};
}

/// Axes that move with two points.
class Frame {
public:
    Frame(Vec2 first, Vec2 second) : middle_{0.5 * (first + second)}
    {
        const double distance = scene::distance(first, second);
        along_ = distance == 0 ? Vec2{1, 0} : 1 / distance * (first - second);
    }
    Vec2 inward(Vec2 direction) const
    {
        return {scene::dot(direction, along_), scene::cross(along_, direction)};
    }
    Vec2 outward(Vec2 direction) const
    {
        return direction.x * along_ + direction.y * Vec2{-along_.y, along_.x};
    }
    Vec2 place_inward(Vec2 place) const { return inward(place - middle_); }
    Vec2 place_outward(Vec2 place) const { return middle_ + outward(place); }

private:
    Vec2 middle_;
    Vec2 along_;
};

class Points {
public:
    Points(Evaluator& evaluator, const ValueNode& node, double time)
        : evaluator_{evaluator}, node_{node}, time_{time}
    {
        for (const Entry& entry : node.entries)
            presences_.push_back(presence_at(entry, time));
    }

    List list()
    {
        for (std::size_t i = 0; i < presences_.size(); ++i)
            if (presences_[i].amount >= 1)
                add(point(i, time_), 1);
            else if (presences_[i].amount > 0)
                add_partly(i);
        return result();
    }

private:
    SplinePoint point(std::size_t index, double time)
    {
        return evaluator_.at(*node_.entries[index].value, time).as<SplinePoint>();
    }

    /// The nearest whose presence is greater than that of `index`; itself if there is none.
    std::size_t neighbour(std::size_t index, bool forward) const
    {
        const std::size_t count = presences_.size();
        for (std::size_t step = 1; step < count; ++step) {
            const std::size_t at = forward ? index + step : index + count - step;
            if (!node_.loop && (forward ? at >= count : at < count))
                break;
            if (presences_[at % count].amount > presences_[index].amount)
                return at % count;
        }
        return index;
    }

    Frame frame(std::size_t before, std::size_t behind, double time)
    {
        return {point(before, time).vertex, point(behind, time).vertex};
    }

    void add_partly(std::size_t index)
    {
        const Presence& presence = presences_[index];
        const std::size_t before = neighbour(index, false);
        const std::size_t behind = neighbour(index, true);
        const SplinePoint on = point(index, presence.on_time);
        const SplinePoint first = point(before, presence.off_time);
        const SplinePoint last = point(behind, presence.off_time);
        const SplinePiece gone{first, last};
        const Frame off_frame{first.vertex, last.vertex};
        const Frame on_frame = frame(before, behind, presence.on_time);
        const Frame now = frame(before, behind, time_);
        const double amount = presence.amount;
        const auto direction = [&](Vec2 tangent) {
            return now.outward(
                swung(off_frame.inward(gone.direction(on.origin)), on_frame.inward(tangent), amount));
        };
        SplinePoint here = on;
        here.vertex = now.place_outward(
            mixed(off_frame.place_inward(gone.at(on.origin)), on_frame.place_inward(on.vertex), amount));
        here.arriving = direction(on.arriving);
        here.second = direction(on.leaving());
        here.split_angle = here.split_radius = true;
        here.width = art::mixed(art::mixed(first.width, last.width, on.origin), on.width, amount);
        const std::size_t count = presences_.size();
        const bool first_of_gap = (before + 1) % count == index || points_.empty();
        const double since = first_of_gap ? on.origin : on.origin - points_.back().origin;
        const bool last_of_gap = (index + 1) % count == behind;
        const double until = (last_of_gap ? 1 : point((index + 1) % count, time_).origin) - on.origin;
        add(here, art::mixed(since, 1, amount));
        shrinks_next_ = art::mixed(until, 1, amount);
    }

    /// Adds a point, with shorter tangents between it and the point before it.
    void add(SplinePoint point, double shrinks)
    {
        const double factor = shrinks_next_.value_or(shrinks);
        shrinks_next_.reset();
        if (factor != 1) {
            split(point).arriving = factor * point.arriving;
            if (!points_.empty())
                split(points_.back()).second = factor * points_.back().second;
        }
        points_.push_back(point);
    }

    static SplinePoint& split(SplinePoint& point)
    {
        point.second = point.leaving();
        point.split_angle = point.split_radius = true;
        return point;
    }

    List result()
    {
        if (shrinks_next_ && !points_.empty())
            split(points_.back()).second = *shrinks_next_ * points_.back().second;
        List list{{}, node_.loop};
        for (const SplinePoint& point : points_)
            list.entries.push_back({point});
        return list;
    }

    Evaluator& evaluator_;
    const ValueNode& node_;
    double time_;
    std::vector<Presence> presences_;
    std::vector<SplinePoint> points_;
    std::optional<double> shrinks_next_;
};

}

Vec2 SplinePiece::at(double share) const
{
    const double rest = 1 - share;
    return rest * rest * (1 + 2 * share) * from + share * share * (3 - 2 * share) * to +
           share * rest * rest * leaving - share * share * rest * arriving;
}

Vec2 SplinePiece::direction(double share) const
{
    const double rest = 1 - share;
    return 6 * share * rest * (to - from) + rest * (1 - 3 * share) * leaving -
           share * (2 * rest - share) * arriving;
}

double SplinePiece::length(double share) const
{
    constexpr int steps = 32;
    double total = 0;
    Vec2 last = from;
    for (int i = 1; i <= steps; ++i) {
        const Vec2 next = at(share * i / steps);
        total += scene::distance(last, next);
        last = next;
    }
    return total;
}

List spline_list(Evaluator& evaluator, const ValueNode& node, double time)
{
    return Points{evaluator, node, time}.list();
}

}
