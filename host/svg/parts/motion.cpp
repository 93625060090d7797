#include "host/svg/parts/motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kfast::svg {
namespace {

using art::Affine;
using scene::Vec2;

constexpr double nearly_nothing = 1e-7;

std::vector<Vec2> spots_of(const art::Drawing& drawing)
{
    std::vector<Vec2> spots;
    for (const scene::Outline& outline : drawing.outlines) {
        spots.push_back(outline.from);
        for (const scene::Curve& curve : outline.curves) {
            if (curve.cubic)
                spots.insert(spots.end(), {curve.c1, curve.c2});
            spots.push_back(curve.to);
        }
    }
    return spots;
}

Vec2 mean(const std::vector<Vec2>& spots)
{
    Vec2 sum;
    for (const Vec2 spot : spots)
        sum = sum + spot;
    return (1 / static_cast<double>(spots.size())) * sum;
}

/// The least-squares solution for the fixed point of all affines: (A - I) p + t = 0 for each of them.
std::optional<Vec2> fixed_point(std::span<const Affine> affines)
{
    double xx = 0;
    double xy = 0;
    double yy = 0;
    Vec2 right;
    for (const Affine& m : affines) {
        const Vec2 first{m.a - 1, m.b};
        const Vec2 second{m.c, m.d - 1};
        const Vec2 moved{m.e, m.f};
        xx += scene::dot(first, first);
        xy += scene::dot(first, second);
        yy += scene::dot(second, second);
        right = right - Vec2{scene::dot(first, moved), scene::dot(second, moved)};
    }
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > nearly_nothing * nearly_nothing))
        return std::nullopt;
    return Vec2{(right.x * yy - right.y * xy) / determinant, (right.y * xx - right.x * xy) / determinant};
}

}

std::optional<Move> move_of(const Affine& m)
{
    const double scale_x = std::sqrt(m.a * m.a + m.b * m.b);
    const double other = std::sqrt(m.c * m.c + m.d * m.d);
    if (scale_x < nearly_nothing && other < nearly_nothing)
        return Move{0, 0, 0, {m.e, m.f}};
    if (scale_x < nearly_nothing || std::abs(m.a * m.c + m.b * m.d) > 1e-5 * scale_x * other)
        return std::nullopt;
    return Move{
        scale_x, m.determinant() / scale_x, std::atan2(m.b, m.a) * 180 / std::numbers::pi, {m.e, m.f}};
}

Vec2 pivot_of(std::span<const Affine> affines, const Box& box)
{
    const auto fixed = fixed_point(affines);
    const Vec2 margin = 0.5 * (box.max - box.min);
    const bool near = fixed && fixed->x >= box.min.x - margin.x && fixed->x <= box.max.x + margin.x &&
                      fixed->y >= box.min.y - margin.y && fixed->y <= box.max.y + margin.y;
    return near ? *fixed : box.centre();
}

/// As complex numbers the affine is a z + b; a is the least-squares solution.
std::optional<Affine> similarity(const art::Drawing& from, const art::Drawing& to, double tolerance)
{
    if (!art::same_form(from, to))
        return std::nullopt;
    const auto before = spots_of(from);
    const auto after = spots_of(to);
    if (before.empty() || before.size() != after.size())
        return std::nullopt;
    const Vec2 middle = mean(before);
    const Vec2 new_middle = mean(after);
    double extent = 0;
    Vec2 rotation;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const Vec2 one = before[i] - middle;
        const Vec2 other = after[i] - new_middle;
        extent += scene::dot(one, one);
        rotation = rotation + Vec2{scene::dot(one, other), scene::cross(one, other)};
    }
    rotation = extent > 0 ? (1 / extent) * rotation : Vec2{1, 0};
    const Affine result = art::moved(new_middle.x, new_middle.y) *
                          Affine{rotation.x, rotation.y, -rotation.y, rotation.x, 0, 0} *
                          art::moved(-middle.x, -middle.y);
    for (std::size_t i = 0; i < before.size(); ++i)
        if (!(scene::distance(result.of(before[i]), after[i]) <= tolerance))
            return std::nullopt;
    return result;
}

bool is_even(const Affine& m)
{
    const double size = m.a * m.a + m.b * m.b + m.c * m.c + m.d * m.d;
    return size - 2 * std::abs(m.determinant()) <= 1e-4 * size; // (s1 - s2)^2 of the two scales
}

bool is_near(const Affine& left, const Affine& right)
{
    const auto near = [](double one, double other) { return std::abs(one - other) <= 1e-6; };
    return near(left.a, right.a) && near(left.b, right.b) && near(left.c, right.c) && near(left.d, right.d) &&
           near(left.e, right.e) && near(left.f, right.f);
}

}
