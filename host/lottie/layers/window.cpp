#include "host/lottie/layers/window.hpp"

#include "host/art/document/document.hpp"
#include "host/art/geometry/convex_polygon.hpp"
#include "host/lottie/drawings/carried.hpp"
#include "host/lottie/drawings/extent.hpp"
#include "host/lottie/shapes/transform.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

namespace kfast::lottie {
namespace {

using art::Affine;
using art::ConvexPolygon;
using art::Drawing;
using scene::Vec2;

/// The transforms around a shape, the outermost first.
using TransformChain = std::vector<art::Transform>;

bool is_upright_rectangle(const ConvexPolygon& polygon)
{
    const std::vector<Vec2>& corners = polygon.corners();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 side = corners[(i + 1) % corners.size()] - corners[i];
        if (side.x != 0 && side.y != 0)
            return false;
    }
    return corners.size() == 4;
}

/// At all times: between two upright rectangles there are only upright rectangles.
bool is_convex(const art::Animated<Drawing>& drawing)
{
    return std::ranges::all_of(drawing.keys, [&](const auto& key) {
        const auto polygon = ConvexPolygon::of(key.value);
        return polygon && (drawing.is_still() || is_upright_rectangle(*polygon));
    });
}

Affine matrix_of(const TransformChain& way, double time)
{
    Affine matrix;
    for (const art::Transform& transform : way)
        matrix = matrix * art::matrix_at(transform, time);
    return matrix;
}

Drawing mapped(const Affine& affine, Drawing drawing)
{
    for (scene::Outline& outline : drawing.outlines)
        outline = affine.of(outline);
    return drawing;
}

std::vector<Vec2> points_of(const Drawing& drawing)
{
    std::vector<Vec2> points;
    for (const scene::Outline& outline : drawing.outlines) {
        points.push_back(outline.from);
        for (const scene::Curve& curve : outline.curves) {
            if (curve.cubic)
                points.insert(points.end(), {curve.c1, curve.c2});
            points.push_back(curve.to);
        }
    }
    return points;
}

Drawing cut_by(const Drawing& polygon, const Drawing& drawing)
{
    const auto convex = ConvexPolygon::of(polygon);
    return convex ? convex->cut(drawing) : Drawing{};
}

/// Whether to cut shapes whose part inside changes, so that it is baked.
enum class Moving { cut, stays };

class Cutter {
public:
    Cutter(const Window& window, Moving moving, const art::Span& seen, art::Budget& budget)
        : window_{window}, moving_{moving}, seen_{seen}, budget_{budget}
    {
    }

    void cut(std::vector<art::Node>& nodes)
    {
        std::erase_if(nodes, [&](art::Node& node) { return !leaves_something(node); });
    }

    bool is_all_cut() const { return is_all_cut_; }
    /// Whether moving shapes take so much that it is better not to cut them.
    bool is_too_much() const { return is_too_much_; }

private:
    bool leaves_something(art::Node& node)
    {
        if (steady_value(node.opacity) == 0.0)
            return false;
        way_.push_back(node.transform);
        bool something = true;
        if (auto* group = std::get_if<art::Group>(&node.content)) {
            cut(group->nodes);
            something = !group->nodes.empty();
        } else {
            something = cut(std::get<art::Shape>(node.content));
        }
        way_.pop_back();
        return something;
    }

    /// Whether something of it is left.
    bool cut(art::Shape& shape)
    {
        const Coverage coverage = coverage_of(shape);
        if (coverage != Coverage::part)
            return coverage == Coverage::all;
        const bool is_polygon = !window_.is_convex && is_convex(shape.drawing);
        const bool can_be_cut =
            !shape.stroke && (window_.is_convex || is_polygon) && std::ranges::all_of(way_, is_flat);
        MovingDrawing part = within(shape.drawing);
        if (!can_be_cut || !is_affordable(part)) {
            is_all_cut_ = false;
            return true;
        }
        if (is_polygon)
            shape.fill->rule = window_.rule;
        shape.drawing = keys_of(part, budget_);
        count_points(shape.drawing);
        return std::ranges::any_of(shape.drawing.keys,
                                   [](const auto& key) { return !key.value.outlines.empty(); });
    }

    /// How much of the shape is inside; the same at all times, or part.
    Coverage coverage_of(const art::Shape& shape) const
    {
        std::optional<Coverage> all_along;
        const double cost = window_.drawing.cost + moving(shape.drawing).cost;
        for (const double time : sample_times(seen_, static_cast<std::size_t>(cost) + way_.size(), budget_)) {
            const Coverage now = coverage_at(shape, time);
            if (now == Coverage::part || (all_along && *all_along != now))
                return Coverage::part;
            all_along = now;
        }
        return all_along.value_or(Coverage::all);
    }

    Coverage coverage_at(const art::Shape& shape, double time) const
    {
        const Affine matrix = matrix_of(way_, time);
        const std::vector<Vec2> points = points_of(mapped(matrix, shape.drawing.at(time)));
        const double scale_factor = std::sqrt(std::abs(matrix.determinant()));
        const double half = shape.stroke ? shape.stroke->width.at(time) * scale_factor / 2 : 0;
        const Drawing window = window_.drawing.at(time);
        if (const auto polygon = ConvexPolygon::of(window)) {
            if (polygon->misses(points, half))
                return Coverage::nothing;
            return polygon->contains(points, half) ? Coverage::all : Coverage::part;
        }
        Box box;
        for (const Vec2 point : points) {
            box.include(point - Vec2{half, half});
            box.include(point + Vec2{half, half});
        }
        return lottie::coverage_of(box, window);
    }

    MovingDrawing within(const art::Animated<Drawing>& drawing) const
    {
        MovingDrawing part = moving(drawing);
        for (const art::Transform& transform : way_)
            part.moments.add(moments_of(transform));
        part.moments.add(window_.drawing.moments);
        part.changes_form = true;
        part.cost += window_.drawing.cost + static_cast<double>(way_.size());
        part.cost *= cost_of_cutting;
        part.at = [at = std::move(part.at), window = window_.drawing.at, convex = window_.is_convex,
                   way = std::make_shared<const TransformChain>(way_)](double time) -> Drawing {
            const auto back = matrix_of(*way, time).inverse();
            if (!back)
                return {};
            const Drawing hole = mapped(*back, window(time));
            return convex ? cut_by(hole, at(time)) : cut_by(at(time), hole);
        };
        return part;
    }

    /// Whether finding the keys is within the budget, and leaves enough for what comes after.
    bool is_affordable(const MovingDrawing& drawing)
    {
        constexpr double looks_per_frame = 40;
        constexpr double max_computed = 1 << 23;
        if (drawing.moments.empty())
            return true;
        if (moving_ == Moving::stays || is_too_much_)
            return false;
        const double frames = drawing.moments.list().rbegin()->first - drawing.moments.list().begin()->first;
        computed_ += drawing.cost * looks_per_frame * frames;
        is_too_much_ = computed_ > max_computed ||
                       budget_.computed_points_left() < art::Budget::max_computed_points / 4 * 3;
        return !is_too_much_;
    }

    void count_points(const art::Animated<Drawing>& drawing)
    {
        constexpr std::size_t max_points = 1 << 15;
        if (!drawing.is_still())
            for (const auto& key : drawing.keys)
                points_ += points_of(key.value).size();
        is_too_much_ = is_too_much_ || points_ > max_points;
    }

    static constexpr double cost_of_cutting = 8;

    const Window& window_;
    const Moving moving_;
    const art::Span& seen_;
    art::Budget& budget_;
    TransformChain way_;
    double computed_ = 0;
    std::size_t points_ = 0;
    bool is_all_cut_ = true;
    bool is_too_much_ = false;
};

}

Window window_of(const art::Animated<Drawing>& drawing)
{
    return {.drawing = moving(drawing), .is_convex = is_convex(drawing)};
}

bool cut_to(const Window& window, std::vector<art::Node>& nodes, const art::Span& seen, art::Budget& budget)
{
    const std::vector<art::Node> whole = nodes;
    Cutter cutter{window, Moving::cut, seen, budget};
    cutter.cut(nodes);
    if (!cutter.is_too_much())
        return cutter.is_all_cut();
    nodes = whole;
    Cutter{window, Moving::stays, seen, budget}.cut(nodes);
    return false;
}

}
