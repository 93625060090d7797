#include "host/synfig/evaluation/evaluator.hpp"

#include "host/art/geometry/affine.hpp"

#include <algorithm>
#include <cmath>

namespace kfast::synfig {
namespace {

Value add(Evaluator& evaluator, const ValueNode& node, double time)
{
    return product(sum(evaluator.link(node, "lhs", time), evaluator.link(node, "rhs", time)),
                   evaluator.number(node, "scalar", time, 1));
}

Value subtract(Evaluator& evaluator, const ValueNode& node, double time)
{
    return product(difference(evaluator.link(node, "lhs", time), evaluator.link(node, "rhs", time)),
                   evaluator.number(node, "scalar", time, 1));
}

/// A colour keeps its opacity.
Value scale(Evaluator& evaluator, const ValueNode& node, double time)
{
    const Value value = evaluator.link(node, "link", time);
    Value scaled = product(value, evaluator.number(node, "scalar", time, 1));
    if (Colour* colour = std::get_if<Colour>(&scaled.held))
        colour->alpha = value.as<Colour>().alpha;
    return node.type == "integer" ? rounded(scaled) : scaled;
}

Value linear(Evaluator& evaluator, const ValueNode& node, double time)
{
    return sum(evaluator.link(node, "offset", time), product(evaluator.link(node, "slope", time), time));
}

Value sine(Evaluator& evaluator, const ValueNode& node, double time)
{
    return {std::sin(art::degree * evaluator.number(node, "angle", time)) *
            evaluator.number(node, "amp", time, 1)};
}

Value cosine(Evaluator& evaluator, const ValueNode& node, double time)
{
    return {std::cos(art::degree * evaluator.number(node, "angle", time)) *
            evaluator.number(node, "amp", time, 1)};
}

Value arc_tangent(Evaluator& evaluator, const ValueNode& node, double time)
{
    return {std::atan2(evaluator.number(node, "y", time), evaluator.number(node, "x", time)) / art::degree};
}

Value exponential(Evaluator& evaluator, const ValueNode& node, double time)
{
    return {std::exp(evaluator.number(node, "exp", time)) * evaluator.number(node, "scale", time, 1)};
}

double min(Evaluator& evaluator, const ValueNode& node, double time)
{
    return std::max(1e-8, evaluator.number(node, "epsilon", time, 1e-6));
}

double max(Evaluator& evaluator, const ValueNode& node, double time)
{
    return evaluator.number(node, "infinite", time, 999999);
}

Value logarithm(Evaluator& evaluator, const ValueNode& node, double time)
{
    const double value = evaluator.number(node, "link", time);
    return {value < min(evaluator, node, time) ? -max(evaluator, node, time) : std::log(value)};
}

Value reciprocal(Evaluator& evaluator, const ValueNode& node, double time)
{
    const double value = evaluator.number(node, "link", time);
    if (std::abs(value) < min(evaluator, node, time))
        return {std::copysign(max(evaluator, node, time), value)};
    return {1 / value};
}

Value power(Evaluator& evaluator, const ValueNode& node, double time)
{
    const double base = evaluator.number(node, "base", time);
    const double exponent = evaluator.number(node, "power", time);
    const double small = min(evaluator, node, time);
    if (std::abs(exponent) < small)
        return {1.0};
    if (std::abs(base) < small)
        return {exponent > 0 ? 0 : max(evaluator, node, time)};
    return {std::pow(base, base <= small ? std::trunc(exponent) : exponent)};
}

Value range(Evaluator& evaluator, const ValueNode& node, double time)
{
    const double value = evaluator.number(node, "link", time);
    return {
        std::max(evaluator.number(node, "min", time), std::min(evaluator.number(node, "max", time), value))};
}

Value dot_product(Evaluator& evaluator, const ValueNode& node, double time)
{
    const Vec2 left = evaluator.spot(node, "lhs", time);
    const Vec2 right = evaluator.spot(node, "rhs", time);
    const double product = scene::dot(left, right);
    if (node.type != "angle")
        return {product};
    const double lengths = std::sqrt(scene::dot(left, left) * scene::dot(right, right));
    return {lengths == 0 ? 0 : std::acos(std::clamp(product / lengths, -1.0, 1.0)) / art::degree};
}

Value number_of(Evaluator& evaluator, const ValueNode& node, double time)
{
    const double value = evaluator.number(node, "link", time);
    if (node.type == "bool")
        return {value != 0};
    return {node.type == "integer" ? std::trunc(value) : value};
}

Value compare(Evaluator& evaluator, const ValueNode& node, double time)
{
    const double left = evaluator.number(node, "lhs", time);
    const double right = evaluator.number(node, "rhs", time);
    return {(left > right && evaluator.truth(node, "greater", time)) ||
            (left == right && evaluator.truth(node, "equal", time)) ||
            (left < right && evaluator.truth(node, "less", time))};
}

Value both(Evaluator& evaluator, const ValueNode& node, double time)
{
    return {evaluator.truth(node, "link1", time) && evaluator.truth(node, "link2", time)};
}

Value either(Evaluator& evaluator, const ValueNode& node, double time)
{
    return {evaluator.truth(node, "link1", time) || evaluator.truth(node, "link2", time)};
}

Value negation(Evaluator& evaluator, const ValueNode& node, double time)
{
    return {!evaluator.truth(node, "link", time)};
}

}

Value rounded(const Value& value) { return {std::floor(value.number() + 0.5)}; }

ValueLaws arithmetic_laws()
{
    return {{"add", add},
            {"subtract", subtract},
            {"scale", scale},
            {"linear", linear},
            {"sine", sine},
            {"cos", cosine},
            {"atan2", arc_tangent},
            {"exp", exponential},
            {"logarithm", logarithm},
            {"power", power},
            {"reciprocal", reciprocal},
            {"range", range},
            {"fromint", number_of},
            {"fromreal", number_of},
            {"dotproduct", dot_product},
            {"compare", compare},
            {"and", both},
            {"or", either},
            {"not", negation}};
}

}
