#pragma once

#include "host/scene/model.hpp"

namespace kfast::test {

/// In pixels.
struct Exact {
    double x;
    double y;
};

inline Exact exact(scene::Point point) { return {point.x / 16.0, point.y / 16.0}; }

/// The point at `t`, 0 to 1, of the cubic `s` that begins at `from`.
inline Exact on_cubic(scene::Point from, const scene::Segment& s, double t)
{
    const double u = 1 - t;
    const auto blend = [&](double a, double b, double c, double d) {
        return u * u * u * a + 3 * u * u * t * b + 3 * u * t * t * c + t * t * t * d;
    };
    const Exact p = exact(from);
    const Exact q = exact(s.c1);
    const Exact r = exact(s.c2);
    const Exact e = exact(s.to);
    return {blend(p.x, q.x, r.x, e.x), blend(p.y, q.y, r.y, e.y)};
}

}
