#include "core/scene_view.hpp"
#include "tests/host/compiler/scene_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>
#include <random>

/// Curves as they are seen in space.
namespace kfast::test {
namespace {

constexpr int side = 200;
constexpr double camera = 300;

struct Place {
    double x;
    double y;
    double z;
};

Place operator+(Place a, Place b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Place operator*(double factor, Place a) { return {factor * a.x, factor * a.y, factor * a.z}; }

/// Turns (a, b) from a towards b.
void turn(double& a, double& b, std::int32_t angle)
{
    const double radians = angle / 65536.0 * 2 * std::numbers::pi;
    const double turned = a * std::cos(radians) - b * std::sin(radians);
    b = a * std::sin(radians) + b * std::cos(radians);
    a = turned;
}

/// What an item does at all times.
struct Posture {
    std::int32_t z;
    std::int32_t rotation_x;
    std::int32_t rotation_y;
    std::int32_t rotation;
    std::int32_t scale;
    std::int32_t pivot_x;
    std::int32_t pivot_y;

    std::vector<scene::Track> tracks() const
    {
        return {fixed(Property::z, z),
                fixed(Property::rotation_x, rotation_x),
                fixed(Property::rotation_y, rotation_y),
                fixed(Property::rotation, rotation),
                fixed(Property::scale_x, scale),
                fixed(Property::scale_y, scale),
                fixed(Property::pivot_x, pivot_x),
                fixed(Property::pivot_y, pivot_y)};
    }

    Place of(Place at) const
    {
        const Place pivot{pivot_x / 16.0, pivot_y / 16.0, 0};
        at = {(at.x - pivot.x) * scale / 4096, (at.y - pivot.y) * scale / 4096, at.z};
        turn(at.x, at.y, rotation);
        turn(at.z, at.x, rotation_y);
        turn(at.y, at.z, rotation_x);
        return at + pivot + Place{0, 0, z / 16.0};
    }
};

struct Spot {
    double x;
    double y;
    bool is_on_canvas() const { return std::abs(x) <= side / 2.0 && std::abs(y) <= side / 2.0; }
};

/// From the centre of the canvas.
Spot seen(Place at)
{
    const double factor = camera / std::max(camera - at.z, camera / 16);
    return {factor * (at.x - side / 2.0), factor * (at.y - side / 2.0)};
}

double distance(Spot at, Spot a, Spot b)
{
    const double length = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
    if (length < 1e-6)
        return 0;
    return std::abs((b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x)) / length;
}

class Trial {
public:
    explicit Trial(std::mt19937& random) : random_{random} {}

    /// How far the pieces of a curve in a group are from it on the canvas.
    double worst()
    {
        const std::array<scene::Point, 4> points{point(), point(), point(), point()};
        inner_ = posture();
        outer_ = posture();
        const scene::Item object =
            item(filled({key(0, curve(points[0], points[1], points[2], points[3]))}), inner_.tracks());
        scene::Scene scene = scene_of({item(scene::Group{{object}}, outer_.tracks())});
        scene.canvas = {side, side};
        scene.camera = static_cast<int>(camera);
        const std::vector<std::byte> bytes = written(scene);
        const ItemView group = SceneView::parse(bytes)->items().next();
        const std::uint32_t pieces = ItemCursor{group.items}.next().object.keys().next().curve_pieces;
        double worst = 0;
        for (std::uint32_t i = 0; i < pieces; ++i) {
            const Spot from = on_canvas(points, 1.0 * i / pieces);
            const Spot to = on_canvas(points, (i + 1.0) / pieces);
            const Spot middle = on_canvas(points, (i + 0.5) / pieces);
            if (middle.is_on_canvas())
                worst = std::max(worst, distance(middle, from, to));
        }
        return worst;
    }

private:
    std::int32_t within(std::int32_t least, std::int32_t most)
    {
        return least + static_cast<std::int32_t>(random_() % static_cast<std::uint32_t>(most - least + 1));
    }

    scene::Point point()
    {
        const auto x = static_cast<std::int16_t>(within(0, side * 16));
        return {x, static_cast<std::int16_t>(within(0, side * 16))};
    }

    Posture posture()
    {
        const std::int32_t tilt = random_() % 2 == 0 ? 5000 : 30'000;
        const std::int32_t z = within(-1000, 1000);
        const std::int32_t about_x = within(-tilt, tilt);
        const std::int32_t about_y = within(-tilt, tilt);
        const std::int32_t about_z = within(-30'000, 30'000);
        const std::int32_t scale = within(1000, 6000);
        const scene::Point pivot = point();
        return {z, about_x, about_y, about_z, scale, pivot.x, pivot.y};
    }

    Spot on_canvas(const std::array<scene::Point, 4>& points, double t) const
    {
        const auto place = [&points](std::size_t i) {
            return Place{points[i].x / 16.0, points[i].y / 16.0, 0};
        };
        const double s = 1 - t;
        const Place at =
            s * s * s * place(0) + 3 * s * s * t * place(1) + 3 * s * t * t * place(2) + t * t * t * place(3);
        return seen(outer_.of(inner_.of(at)));
    }

    std::mt19937& random_;
    Posture inner_{};
    Posture outer_{};
};

}

TEST_CASE("pieces keep within 1/32 px of their curve as it is seen in space")
{
    std::mt19937 random{33};
    double worst = 0;
    double typical = 0;
    for (int round = 0; round < 400; ++round) {
        const double distance = Trial{random}.worst();
        worst = std::max(worst, distance);
        typical += distance / 400;
    }
    CHECK(worst <= 1 / 32.0);
    CHECK(worst > 1 / 100.0);
    CHECK(typical > 1 / 1000.0);
}

}
