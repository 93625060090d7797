#pragma once

#include "core/math/projection.hpp"
#include "core/math/stroke_trimmer.hpp"
#include "tests/core/array_drawing.hpp"
#include "tests/core/spot.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <doctest/doctest.h>
#include <random>
#include <vector>

/// Strokes that are cut, and what tells where exactly they should be.
namespace kfast::test {

struct Piece {
    Point from;
    std::vector<Segment> segments;
    Point hub;
    PieceEnd end = PieceEnd::open;

    Point to() const { return segments.empty() ? from : segments.back().to; }
};

/// Keeps the pieces.
struct Pieces {
    std::vector<Piece> all;
    ViewProjection view{nullptr, 0};

    void begin(Point at) { all.push_back({at, {}, {}, {}}); }
    void add(const Segment& segment)
    {
        CHECK(segment.from == all.back().to());
        all.back().segments.push_back(segment);
    }
    void end_piece(Point hub, PieceEnd end)
    {
        all.back().hub = hub;
        all.back().end = end;
    }
    int pieces_of(const Segment& segment) const { return view.pieces_of(segment); }
};

struct TestStroke {
    Point from;
    std::vector<Segment> segments;
    bool is_closed = false;
};

inline std::vector<Piece> trimmed(const std::vector<TestStroke>& strokes, const Trim& trim,
                                  const Affine& placement = {})
{
    Pieces pieces;
    StrokeTrimmer trimmer{trim, placement, PieceSink::of(pieces)};
    trimmer.run([&](StrokeTrimmer& outline) {
        for (const TestStroke& stroke : strokes) {
            outline.begin(stroke.from);
            for (const Segment& segment : stroke.segments)
                outline.add(segment);
            outline.end(stroke.from, stroke.is_closed);
        }
    });
    return pieces.all;
}

inline TestStroke lines(const std::vector<Point>& points, bool is_closed = false)
{
    TestStroke stroke{points.front(), {}, is_closed};
    for (std::size_t i = 1; i < points.size(); ++i)
        stroke.segments.push_back({.from = points[i - 1], .to = points[i]});
    return stroke;
}

inline Spot on_curve(const Segment& cubic, double t)
{
    const double s = 1 - t;
    return s * s * s * spot(cubic.from) + 3 * s * s * t * spot(cubic.c1) + 3 * s * t * t * spot(cubic.c2) +
           t * t * t * spot(cubic.to);
}

/// Points along curves at even steps of their parameter, and the lengths up to there.
struct ExactCurve {
    std::vector<Spot> spots;
    std::vector<double> lengths;

    explicit ExactCurve(const std::vector<Segment>& segments)
    {
        constexpr int steps = 4000;
        for (const Segment& segment : segments)
            for (int i = spots.empty() ? 0 : 1; i <= steps; ++i)
                add(segment.kind == Segment::Kind::cubic
                        ? on_curve(segment, i / double{steps})
                        : spot(segment.from) + i / double{steps} * (spot(segment.to) - spot(segment.from)));
    }

    double length() const { return lengths.back(); }
    Spot at(double part) const { return at_length(part * length()); }
    Spot at_length(double length) const
    {
        const auto after =
            static_cast<std::size_t>(std::ranges::upper_bound(lengths, length) - lengths.begin());
        const std::size_t i = std::clamp<std::size_t>(after, 1, spots.size() - 1);
        const double between = (length - lengths[i - 1]) / (lengths[i] - lengths[i - 1]);
        return spots[i - 1] + between * (spots[i] - spots[i - 1]);
    }

private:
    void add(Spot to)
    {
        const Spot step = spots.empty() ? Spot{} : to - spots.back();
        lengths.push_back((lengths.empty() ? 0 : lengths.back()) + std::hypot(step.x, step.y));
        spots.push_back(to);
    }
};

inline TestStroke random_stroke(std::mt19937& random)
{
    const auto coordinate = [&] {
        return Fixed::from_raw(static_cast<std::int32_t>(random() % (240U << 16)));
    };
    const auto point = [&] {
        const Fixed x = coordinate();
        return Point{x, coordinate()};
    };
    TestStroke stroke{point(), {}};
    Point last = stroke.from;
    for (auto left = 1 + random() % 5; left > 0; --left) {
        Segment segment{.from = last, .to = point()};
        if (random() % 4 != 0)
            segment = {Segment::Kind::cubic, last, point(), point(), point()};
        stroke.segments.push_back(segment);
        last = segment.to;
    }
    return stroke;
}

}
