#include "host/art/geometry/shape_form.hpp"

#include "host/geometry/shape.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

using art::shape_form;
using scene::Outline;
using scene::Vec2;

template <typename Form>
bool is(const Outline& outline)
{
    return std::holds_alternative<Form>(shape_form(outline));
}

Outline reversed_ellipse()
{
    Outline outline = scene::ellipse({50, 50}, 20, 10);
    Outline result{outline.from, {}, true};
    for (std::size_t i = 4; i-- > 0;) {
        const Vec2 to = i == 0 ? outline.from : outline.curves[i - 1].to;
        result.curves.push_back(scene::cubic_to(outline.curves[i].c2, outline.curves[i].c1, to));
    }
    return result;
}

}

TEST_CASE("circles and ellipses are known, with as few decimals as they need")
{
    const auto circle = std::get<art::CircleForm>(shape_form(scene::ellipse({20.001, 29.999}, 16.002, 16)));
    CHECK(circle.centre.x == 20);
    CHECK(circle.centre.y == 30);
    CHECK(circle.radius == 16);
    const auto ellipse = std::get<art::EllipseForm>(shape_form(scene::ellipse({20.3, 30}, 16, 9.5)));
    CHECK(ellipse.centre.x == doctest::Approx(20.3));
    CHECK(ellipse.radius_y == 9.5);
    CHECK(is<art::PathForm>(reversed_ellipse()));
}

TEST_CASE("the form of anything draws the same stroke")
{
    for (int i = 0; i < 500; ++i) {
        const Vec2 centre{i * 0.377, 200 - i * 0.6113};
        const double rx = 1 + i * 0.1234;
        const double ry = i % 3 == 0 ? rx : 2 + i * 0.0817;
        const Outline round = scene::ellipse(centre, rx, ry);
        const auto form = shape_form(round);
        Outline again;
        if (const auto* circle = std::get_if<art::CircleForm>(&form))
            again = scene::ellipse(circle->centre, circle->radius, circle->radius);
        else if (const auto* ellipse = std::get_if<art::EllipseForm>(&form))
            again = scene::ellipse(ellipse->centre, ellipse->radius_x, ellipse->radius_y);
        else
            continue;
        CHECK(scene::quantized(again) == scene::quantized(round));
    }
}

TEST_CASE("nearly all circles and rectangles of any place are known")
{
    int known = 0;
    for (int i = 0; i < 500; ++i) {
        const Vec2 corner{i * 0.377, 200 - i * 0.6113};
        known += is<art::CircleForm>(scene::ellipse(corner, 1 + i * 0.1234, 1 + i * 0.1234)) ? 1 : 0;
        const Outline rect = scene::rectangle(corner, 30 + i * 0.317, 50, i % 2 * 7.3);
        const auto form = shape_form(rect);
        if (const auto* found = std::get_if<art::RectForm>(&form)) {
            ++known;
            CHECK(scene::quantized(scene::rectangle(found->upper_left, found->width, found->height,
                                                    found->corner)) == scene::quantized(rect));
        }
    }
    CHECK(known > 900);
}

TEST_CASE("rectangles are known by their beginning and direction")
{
    const auto rect = std::get<art::RectForm>(shape_form(scene::rectangle({1, 2}, 30, 40, 0)));
    CHECK(rect.upper_left.x == 1);
    CHECK(rect.width == 30);
    CHECK(rect.height == 40);
    CHECK(rect.corner == 0);
    const auto round = std::get<art::RectForm>(shape_form(scene::rectangle({1, 2}, 30, 40, 6.5)));
    CHECK(round.corner == 6.5);
    const auto pill = std::get<art::RectForm>(shape_form(scene::rectangle({1, 2}, 30, 10, 12)));
    CHECK(pill.corner == 12);
    const auto upright = std::get<art::RectForm>(shape_form(scene::rectangle({1, 2}, 10, 30, 5)));
    CHECK(upright.height == 30);
    CHECK(upright.corner == 5);
    const auto turned = std::vector<Vec2>{{31, 2}, {31, 42}, {1, 42}, {1, 2}};
    CHECK(std::get<art::PolygonForm>(shape_form(scene::polyline(turned, true))).spots.size() == 4);
}

TEST_CASE("straight outlines are polygons and lines")
{
    const std::vector<Vec2> spots{{0, 0}, {10.01, 0}, {10, 7}};
    const auto polygon = std::get<art::PolygonForm>(shape_form(scene::polyline(spots, true)));
    CHECK(polygon.spots.size() == 3);
    CHECK(polygon.spots[1].x == 10);
    const std::vector<Vec2> back{{0, 0}, {10, 0}, {10, 7}, {0, 0}};
    CHECK(is<art::PolygonForm>(scene::polyline(back, false)));
    CHECK(std::get<art::LineForm>(shape_form(scene::polyline(spots, false))).spots.size() == 3);
    const std::vector<Vec2> there{{0, 0}, {10, 0}};
    const auto line = std::get<art::LineForm>(shape_form(scene::polyline(there, true)));
    CHECK(line.spots.size() == 3);
    CHECK(line.spots[2].x == 0);
}

TEST_CASE("what nothing else draws is a path")
{
    CHECK(is<art::PathForm>(Outline{{5, 5}, {}, true}));
    CHECK(is<art::PathForm>(Outline{{5, 5}, {scene::line_to({5000, 5})}, false}));
    CHECK(is<art::PathForm>(
        Outline{{5, 5}, {scene::cubic_to({9, 9}, {12, 7}, {15, 5}), scene::line_to({9, 9})}, true}));
    Outline open = scene::ellipse({50, 50}, 20, 10);
    open.curves.pop_back();
    CHECK(is<art::PathForm>(open));
}

}
