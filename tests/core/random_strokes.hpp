#pragma once

#include "host/scene/model.hpp"

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

namespace kfast::test {

/// Drawings with all that the format has a short way for: lines along the axes, smooth and closed strokes,
/// strokes whose second half is the first turned round, curves near parabolas, strokes again and mirrored.
class RandomStrokes {
public:
    explicit RandomStrokes(std::uint32_t seed) : random_{seed} {}

    scene::Drawing drawing()
    {
        scene::Drawing drawing;
        drawing.strokes.resize(random_() % 4);
        for (scene::Stroke& stroke : drawing.strokes)
            stroke = strokes_.empty() || random_() % 4 != 0 ? fresh() : again();
        return drawing;
    }

private:
    scene::Stroke fresh()
    {
        bits_ = 1 + static_cast<int>(random_() % 12);
        is_calm_ = random_() % 2 == 0;
        scene::Stroke stroke{.from = vector(15), .segments = {}};
        const bool only_curves = random_() % 2 == 0;
        for (auto left = random_() % 9; left > 0; --left)
            stroke.segments.push_back(segment(stroke, only_curves || random_() % 2 == 0));
        if (random_() % 3 == 0)
            add_turned_half(stroke);
        else if (random_() % 3 == 0 && !stroke.segments.empty())
            stroke.segments.back().to = stroke.from;
        strokes_.push_back(stroke);
        return stroke;
    }

    scene::Segment segment(const scene::Stroke& stroke, bool cubic)
    {
        const bool is_first = stroke.segments.empty();
        const scene::Point from = is_first ? stroke.from : stroke.segments.back().to;
        scene::Segment segment{.cubic = cubic, .c1 = {}, .c2 = {}, .to = sum(from, vector(bits_))};
        if (!cubic)
            return segment;
        segment.c1 = sum(from, vector(bits_));
        if (!is_first && stroke.segments.back().cubic && random_() % 2 == 0)
            segment.c1 =
                sum(turned(stroke.segments.back().c2, from, from), vector(static_cast<int>(random_() % 3)));
        segment.c2 = sum(segment.to, vector(bits_));
        if (is_calm_)
            calm(segment, from);
        return segment;
    }

    /// Makes it nearly a parabola.
    void calm(scene::Segment& segment, scene::Point from)
    {
        const auto little = [this] { return vector(static_cast<int>(random_() % 4)); };
        const int x = segment.c1.x - from.x;
        const int y = segment.c1.y - from.y;
        const scene::Point more = little();
        segment.to = sum(moved(from, 3 * (2 * x + more.x) / 2, 3 * (2 * y + more.y) / 2), little());
        segment.c2 = moved(segment.to, -x - more.x, -y - more.y);
    }

    static void add_turned_half(scene::Stroke& stroke)
    {
        if (stroke.segments.empty())
            return;
        const std::vector<scene::Segment> half = stroke.segments;
        const scene::Point middle = half.back().to;
        for (scene::Segment segment : half) {
            for (scene::Point scene::Segment::*point :
                 {&scene::Segment::c1, &scene::Segment::c2, &scene::Segment::to})
                if (segment.cubic || point == &scene::Segment::to)
                    segment.*point = turned(segment.*point, stroke.from, middle);
            stroke.segments.push_back(segment);
        }
    }

    /// A stroke that there was before, elsewhere.
    scene::Stroke again()
    {
        scene::Stroke stroke = strokes_[random_() % strokes_.size()];
        const scene::Point old = stroke.from;
        stroke.from = vector(15);
        const int x = random_() % 2 == 0 ? 1 : -1;
        const int y = random_() % 2 == 0 ? 1 : -1;
        for (scene::Segment& segment : stroke.segments)
            for (scene::Point scene::Segment::*point :
                 {&scene::Segment::c1, &scene::Segment::c2, &scene::Segment::to})
                if (segment.cubic || point == &scene::Segment::to)
                    segment.*point = moved(stroke.from, x * ((segment.*point).x - old.x),
                                           y * ((segment.*point).y - old.y));
        return stroke;
    }

    /// Often along an axis; 0 if `bits` is.
    scene::Point vector(int bits)
    {
        const auto coordinate = [this, bits] {
            const auto number = static_cast<std::int32_t>(random_());
            return static_cast<std::int16_t>(bits == 0 || random_() % 4 == 0 ? 0 : number >> (32 - bits));
        };
        const std::int16_t x = coordinate();
        return {x, coordinate()};
    }

    /// Half a turn, and from one centre to the other.
    static scene::Point turned(scene::Point at, scene::Point from, scene::Point to)
    {
        return moved(to, from.x - at.x, from.y - at.y);
    }

    static scene::Point sum(scene::Point a, scene::Point b) { return moved(a, b.x, b.y); }

    static scene::Point moved(scene::Point at, int x, int y)
    {
        const auto held = [](int value) {
            return static_cast<std::int16_t>(std::clamp(value, -32768, 32767));
        };
        return {held(at.x + x), held(at.y + y)};
    }

    std::mt19937 random_;
    int bits_ = 0;
    bool is_calm_ = false;
    std::vector<scene::Stroke> strokes_;
};

}
