#include "host/art/geometry/drawing.hpp"

#include <algorithm>

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

}
