#include "host/synfig/evaluation/evaluator.hpp"

#include "host/art/animation/animated.hpp"
#include "host/art/geometry/affine.hpp"
#include "host/synfig/evaluation/spline_list.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace kfast::synfig {
namespace {

/// A position on a spline: between two of its points.
struct Foot {
    SplinePoint before;
    SplinePoint behind;
    double share = 0;

    SplinePiece piece() const { return {before, behind}; }
};

std::vector<Foot> pieces_of(const List& spline)
{
    std::vector<Foot> pieces;
    const std::size_t count = spline.entries.size();
    for (std::size_t i = 0; i + (spline.loop ? 0 : 1) < count; ++i)
        pieces.push_back(
            {spline.entries[i].as<SplinePoint>(), spline.entries[(i + 1) % count].as<SplinePoint>(), 0});
    return pieces;
}

/// The parameter at a fraction of the length of a piece.
double share_of_length(const SplinePiece& piece, double share)
{
    const double aim = share * piece.length();
    double low = 0;
    double high = 1;
    for (int step = 0; step < 20; ++step) {
        const double middle = (low + high) / 2;
        (piece.length(middle) < aim ? low : high) = middle;
    }
    return (low + high) / 2;
}

Foot foot_by_length(std::vector<Foot> pieces, double amount)
{
    std::vector<double> lengths;
    double total = 0;
    for (const Foot& piece : pieces) {
        lengths.push_back(piece.piece().length());
        total += lengths.back();
    }
    double rest = amount * total;
    std::size_t index = 0;
    while (index + 1 < pieces.size() && rest > lengths[index])
        rest -= lengths[index++];
    Foot foot = pieces[index];
    foot.share =
        lengths[index] == 0 ? 0 : share_of_length(foot.piece(), std::min(1.0, rest / lengths[index]));
    return foot;
}

/// The link "amount" counts points, or the length.
std::optional<Foot> foot_of(Evaluator& evaluator, const ValueNode& node, double time)
{
    std::vector<Foot> pieces = pieces_of(evaluator.link(node, "bline", time).as<List>());
    if (pieces.empty())
        return {};
    double amount = evaluator.number(node, "amount", time);
    if (evaluator.truth(node, "loop", time))
        amount -= std::floor(amount);
    amount = std::clamp(amount, 0.0, 1.0);
    if (evaluator.truth(node, "homogeneous", time))
        return foot_by_length(std::move(pieces), amount);
    const double along = amount * static_cast<double>(pieces.size());
    const std::size_t index = std::min(pieces.size() - 1, static_cast<std::size_t>(along));
    Foot foot = pieces[index];
    foot.share = along - static_cast<double>(index);
    return foot;
}

Value vertex(Evaluator& evaluator, const ValueNode& node, double time)
{
    const auto foot = foot_of(evaluator, node, time);
    return {foot ? foot->piece().at(foot->share) : Vec2{}};
}

Value tangent(Evaluator& evaluator, const ValueNode& node, double time)
{
    const auto foot = foot_of(evaluator, node, time);
    const Vec2 direction = foot ? foot->piece().direction(foot->share) : Vec2{};
    const double angle =
        std::atan2(direction.y, direction.x) + art::degree * evaluator.number(node, "offset", time);
    const double scale = evaluator.number(node, "scale", time, 1);
    const double length = evaluator.truth(node, "fixed_length", time)
                              ? scale
                              : scale * std::sqrt(scene::dot(direction, direction));
    if (node.type == "angle")
        return {angle / art::degree};
    if (node.type == "real")
        return {length};
    return {Vec2{length * std::cos(angle), length * std::sin(angle)}};
}

Value width(Evaluator& evaluator, const ValueNode& node, double time)
{
    const auto foot = foot_of(evaluator, node, time);
    return {foot ? art::mixed(foot->before.width, foot->behind.width, foot->share) *
                       evaluator.number(node, "scale", time, 1)
                 : 0};
}

Value reversed_tangents(Evaluator& evaluator, const ValueNode& node, double time)
{
    Value value = evaluator.link(node, "reference", time);
    SplinePoint* point = std::get_if<SplinePoint>(&value.held);
    if (point && evaluator.truth(node, "reverse", time)) {
        const Vec2 leaving = point->leaving();
        point->second = -1 * point->arriving;
        point->arriving = -1 * leaving;
        point->split_angle = point->split_radius = true;
    }
    return value;
}

Value reversed(Evaluator& evaluator, const ValueNode& node, double time)
{
    Value value = evaluator.link(node, "link", time);
    if (List* list = std::get_if<List>(&value.held)) {
        std::ranges::reverse(list->entries);
        for (Value& entry : list->entries)
            if (SplinePoint* point = std::get_if<SplinePoint>(&entry.held)) {
                const Vec2 leaving = point->leaving();
                point->second = -1 * point->arriving;
                point->arriving = -1 * leaving;
                point->split_angle = point->split_radius = true;
            }
    }
    return value;
}

}

ValueLaws spline_laws()
{
    return {{"blinecalcvertex", vertex},
            {"blinecalctangent", tangent},
            {"blinecalcwidth", width},
            {"blinerevtangent", reversed_tangents},
            {"reverse", reversed}};
}

}
