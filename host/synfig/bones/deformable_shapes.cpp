#include "host/synfig/bones/deformable_shapes.hpp"

#include "host/art/document/document.hpp"

#include <cmath>
#include <utility>

namespace kfast::synfig {

namespace {

using scene::Curve;
using scene::Outline;
using scene::Vec2;

constexpr int deepest = 4;

Vec2 mixed(Vec2 from, Vec2 to, double share) { return from + share * (to - from); }

Curve as_cubic(Vec2 from, const Curve& curve)
{
    return curve.cubic
               ? curve
               : scene::cubic_to(mixed(from, curve.to, 1.0 / 3), mixed(from, curve.to, 2.0 / 3), curve.to);
}

std::pair<Curve, Curve> halves(Vec2 from, const Curve& curve, double share)
{
    const Vec2 first = mixed(from, curve.c1, share);
    const Vec2 middle = mixed(curve.c1, curve.c2, share);
    const Vec2 last = mixed(curve.c2, curve.to, share);
    const Vec2 before = mixed(first, middle, share);
    const Vec2 behind = mixed(middle, last, share);
    const Vec2 spot = mixed(before, behind, share);
    return {scene::cubic_to(first, before, spot), scene::cubic_to(behind, last, curve.to)};
}

void divide(const Curve& curve, Vec2 from, double begin, double end, int depth, double tolerance,
            const std::function<double(const Curve&, Vec2)>& error, std::vector<double>& shares)
{
    if (depth == deepest || error(curve, from) <= tolerance)
        return;
    const auto [first, second] = halves(from, curve, 0.5);
    const double middle = (begin + end) / 2;
    divide(first, from, begin, middle, depth + 1, tolerance, error, shares);
    shares.push_back(middle);
    divide(second, first.to, middle, end, depth + 1, tolerance, error, shares);
}

void add_divided(std::vector<Curve>& curves, Vec2 from, const Curve& curve, const std::vector<double>& shares)
{
    if (shares.empty()) {
        curves.push_back(curve);
        return;
    }
    Curve rest = as_cubic(from, curve);
    double begin = 0;
    for (const double share : shares) {
        const auto [first, second] = halves(from, rest, (share - begin) / (1 - begin));
        curves.push_back(first);
        from = first.to;
        rest = second;
        begin = share;
    }
    curves.push_back(rest);
}

bool ends_at_beginning(const Outline& outline)
{
    return outline.closed && outline.curves.size() > 1 &&
           scene::distance(outline.curves.back().to, outline.from) < 1e-9;
}

}

Vec2 spot_on(const Curve& cubic, Vec2 from, double share)
{
    const double rest = 1 - share;
    return rest * rest * rest * from + 3 * rest * rest * share * cubic.c1 +
           3 * rest * share * share * cubic.c2 + share * share * share * cubic.to;
}

Division division(const art::Drawing& drawing, double tolerance,
                  const std::function<double(const Curve&, Vec2)>& error)
{
    Division result;
    for (const Outline& outline : drawing.outlines) {
        auto& own = result.emplace_back();
        Vec2 from = outline.from;
        for (const Curve& curve : outline.curves) {
            divide(as_cubic(from, curve), from, 0, 1, 0, tolerance, error, own.emplace_back());
            from = curve.to;
        }
    }
    return result;
}

art::Drawing divided(const art::Drawing& drawing, const Division& division)
{
    art::Drawing result;
    for (std::size_t i = 0; i < drawing.outlines.size(); ++i) {
        const Outline& outline = drawing.outlines[i];
        result.outlines.push_back({outline.from, {}, outline.closed});
        Outline& own = result.outlines.back();
        Vec2 from = outline.from;
        for (std::size_t n = 0; n < outline.curves.size(); ++n) {
            add_divided(own.curves, from, outline.curves[n], division[i][n]);
            from = outline.curves[n].to;
        }
    }
    return result;
}

std::vector<Vec2> points_of(const art::Drawing& drawing)
{
    std::vector<Vec2> points;
    for (const Outline& outline : drawing.outlines) {
        points.push_back(outline.from);
        const std::size_t count = outline.curves.size() - (ends_at_beginning(outline) ? 1 : 0);
        for (std::size_t i = 0; i < count; ++i)
            points.push_back(outline.curves[i].to);
    }
    return points;
}

namespace {

using art::Affine;
using art::Transform;

// The channels that groups of Synfig have.
std::vector<const art::Channel*> channels_of(const Transform& transform)
{
    return {&transform.anchor_x, &transform.anchor_y, &transform.x,      &transform.y,
            &transform.scale_x,  &transform.scale_y,  &transform.rotate, &transform.skew};
}

art::Drawing mapped(const Affine& matrix, art::Drawing drawing)
{
    for (scene::Outline& outline : drawing.outlines)
        outline = matrix.of(outline);
    return drawing;
}

template <typename Value>
void add_times(const art::Animated<Value>& animated, std::vector<double>& times)
{
    for (const auto& key : animated.keys)
        times.push_back(key.time);
}

class Flattening {
public:
    explicit Flattening(const Layer& layer) : layer_{layer} {}

    void flatten(std::vector<art::Node>& nodes)
    {
        for (art::Node& node : nodes) {
            path_.push_back(std::move(node.transform));
            node.transform = {};
            if (auto* group = std::get_if<art::Group>(&node.content))
                flatten(group->nodes);
            else
                flatten(std::get<art::Shape>(node.content));
            path_.pop_back();
        }
    }

private:
    void flatten(art::Shape& shape)
    {
        std::vector<double> times;
        for (const Transform& transform : path_)
            for (const art::Channel* channel : channels_of(transform))
                if (!channel->is_still())
                    add_times(*channel, times);
        if (shape.stroke)
            flatten_width(*shape.stroke, times);
        if (times.empty()) {
            for (auto& key : shape.drawing.keys)
                key.value = mapped(matrix(0), std::move(key.value));
            return;
        }
        add_times(shape.drawing, times);
        const std::function<art::Drawing(double)> drawing = [this, &shape](double frame) {
            return mapped(matrix(frame), shape.drawing.at(frame));
        };
        shape.drawing = traced(drawing, tracing(std::move(times)));
    }

    void flatten_width(art::StrokeStyle& stroke, std::vector<double> times)
    {
        const auto scale_factor = [this](double frame) {
            return std::sqrt(std::abs(matrix(frame).determinant()));
        };
        if (times.empty()) {
            for (auto& key : stroke.width.keys)
                key.value *= scale_factor(0);
            return;
        }
        add_times(stroke.width, times);
        const std::function<double(double)> width = [&](double frame) {
            return stroke.width.at(frame) * scale_factor(frame);
        };
        stroke.width = traced(width, tracing(std::move(times)));
    }

    Tracing tracing(std::vector<double> times) const
    {
        return {0, layer_.reading().frames, std::move(times), place_tolerance, &layer_.reading().budget};
    }

    Affine matrix(double frame) const
    {
        Affine result;
        for (const Transform& transform : path_)
            result = result * matrix_at(transform, frame);
        return result;
    }

    const Layer& layer_;
    std::vector<Transform> path_; ///< the outermost first
};

}

void flatten(std::vector<art::Node>& nodes, const Layer& layer) { Flattening{layer}.flatten(nodes); }

}
