#include "host/compiler/stroke_order.hpp"

#include "tests/compiled.hpp"
#include "tests/host/compiler/scene_parts.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>
#include <string>

namespace kfast::test {
namespace {

using Points = std::vector<scene::Point>;

/// The points of a stroke from wherever and whichever way it is followed, so that two of them can be
/// compared.
std::vector<Points> all_ways(const scene::Stroke& stroke)
{
    Points points{stroke.from};
    for (const scene::Segment& segment : stroke.segments) {
        if (segment.cubic) {
            points.push_back(segment.c1);
            points.push_back(segment.c2);
        }
        points.push_back(segment.to);
    }
    std::vector<Points> ways{points, {points.rbegin(), points.rend()}};
    const bool is_closed = points.size() > 2 && points.front() == points.back();
    for (std::size_t shift = 1; is_closed && shift + 1 < points.size(); ++shift)
        for (std::size_t way = 0; way < 2; ++way) {
            Points turned(ways[way].begin(), ways[way].end() - 1);
            std::rotate(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(shift), turned.end());
            turned.push_back(turned.front());
            ways.push_back(turned);
        }
    return ways;
}

/// What is the same for strokes that run through the same points.
Points form_of(const scene::Stroke& stroke)
{
    const std::vector<Points> ways = all_ways(stroke);
    return *std::ranges::min_element(ways, [](const Points& a, const Points& b) {
        return std::ranges::lexicographical_compare(
            a, b, [](scene::Point p, scene::Point q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
    });
}

std::vector<Points> forms_of(const scene::Drawing& drawing)
{
    std::vector<Points> forms;
    for (const scene::Stroke& stroke : drawing.strokes)
        forms.push_back(form_of(stroke));
    std::ranges::sort(forms, [](const Points& a, const Points& b) {
        return std::ranges::lexicographical_compare(
            a, b, [](scene::Point p, scene::Point q) { return p.x != q.x ? p.x < q.x : p.y < q.y; });
    });
    return forms;
}

int distance(scene::Point a, scene::Point b) { return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)); }

scene::Point end_of(const scene::Stroke& stroke)
{
    return stroke.segments.empty() ? stroke.from : stroke.segments.back().to;
}

int travel_of(const scene::Drawing& drawing)
{
    int travel = 0;
    for (std::size_t i = 0; i < drawing.strokes.size(); ++i)
        travel +=
            distance(end_of(drawing.strokes[i]), drawing.strokes[(i + 1) % drawing.strokes.size()].from);
    return travel;
}

scene::Drawing random_drawing(std::mt19937& random)
{
    const auto point = [&random] {
        return scene::Point{static_cast<std::int16_t>(random() % 3000),
                            static_cast<std::int16_t>(random() % 3000)};
    };
    scene::Drawing drawing;
    for (std::size_t left = 2 + random() % 30; left > 0; --left) {
        scene::Stroke stroke{.from = point(), .segments = {}};
        for (std::size_t segments = random() % 5; segments > 0; --segments) {
            const bool is_cubic = random() % 2 == 0;
            stroke.segments.push_back({is_cubic, is_cubic ? point() : scene::Point{},
                                       is_cubic ? point() : scene::Point{}, point()});
        }
        if (stroke.segments.size() > 1 && random() % 2 == 0)
            stroke.segments.back().to = stroke.from;
        drawing.strokes.push_back(stroke);
    }
    return drawing;
}

std::string text_scene(const std::string& canvas, const std::string& object)
{
    return "kfast 1\ncanvas 256 256 " + canvas + "\nobject o " + object +
           " { text \"VECTORS\" at=\"10,100\" size=40 font=hershey-sans }";
}

}

TEST_CASE("strokes stay what they are in an order with less travel")
{
    std::mt19937 random{5};
    for (int i = 0; i < 100; ++i) {
        const scene::Drawing drawing = random_drawing(random);
        scene::Drawing ordered = drawing;
        order_strokes(ordered);
        CHECK(forms_of(ordered) == forms_of(drawing));
        CHECK(travel_of(ordered) <= travel_of(drawing));
        scene::Drawing again = drawing;
        order_strokes(again);
        CHECK(again == ordered);
    }
}

TEST_CASE("a row of lines is followed there and back")
{
    scene::Drawing ladder;
    for (std::int16_t x = 0; x < 160; x = static_cast<std::int16_t>(x + 16))
        ladder.strokes.push_back(lines({{x, 0}, {x, 160}}).strokes.front());
    order_strokes(ladder);
    CHECK(travel_of(ladder) <= 9 * 16 + 9 * 16);
}

TEST_CASE("only strokes that never change are put in order, and only if the canvas says so")
{
    const auto differs = [](const std::string& object) {
        return compiled(text_scene("", object)) != compiled(text_scene("route=#true", object));
    };
    CHECK(differs("stroke=white"));
    CHECK(!differs("fill=white"));
    CHECK(!differs("fill=white stroke=white"));
    CHECK(compiled(text_scene("", "stroke=white")) == compiled(text_scene("route=#false", "stroke=white")));
}

TEST_CASE("wire frames keep their order, which that of their depths follows")
{
    const auto wires = [](const std::string& canvas) {
        return "kfast 1\ncanvas 256 256 " + canvas +
               "\nobject o stroke=white { wire 0 0 1 9 0 2; wire 90 0 3 99 0 4 90 9 5; wire 20 0 6 10 0 7 }";
    };
    CHECK(compiled(wires("route=#true")) == compiled(wires("")));
}

}
