#include "core/flatten.hpp"
#include "core/key_interval.hpp"
#include "core/scene_view.hpp"
#include "tests/host/compiler/scene_parts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>
#include <random>

/// Curves as they are seen: through laws, tracks, groups and symbols.
namespace kfast::test {
namespace {

struct Spot {
    double x;
    double y;
};

/// Columns are where the unit vectors go.
struct Matrix {
    Spot x{1, 0};
    Spot y{0, 1};

    Spot operator*(Spot at) const { return {x.x * at.x + y.x * at.y, x.y * at.x + y.y * at.y}; }
    Matrix operator*(const Matrix& inner) const { return {*this * inner.x, *this * inner.y}; }
};

double share_of(Way way) { return static_cast<double>(way.raw) / Way::one; }

double value_at(const scene::Track& track, Time time, bool by_y)
{
    const scene::TrackKey& from = track.keys[0];
    const scene::TrackKey& to = track.keys[1];
    const Progress way = progress_between(from.time, to.time, time, from.laws);
    return from.value + (to.value - from.value) * share_of(by_y ? way.y : way.x);
}

/// Of tracks in the order rotation, scale-x, scale-y.
Matrix matrix_at(const std::vector<scene::Track>& tracks, Time time)
{
    const double angle = value_at(tracks[0], time, false) / 65536 * 2 * std::numbers::pi;
    const double scale_x = value_at(tracks[1], time, false) / 4096;
    const double scale_y = value_at(tracks[2], time, true) / 4096;
    return {{std::cos(angle) * scale_x, std::sin(angle) * scale_x},
            {-std::sin(angle) * scale_y, std::cos(angle) * scale_y}};
}

using Curve = std::array<Spot, 4>;

Spot between(Spot a, Spot b, double share)
{
    return {std::lerp(a.x, b.x, share), std::lerp(a.y, b.y, share)};
}

Spot on(const Curve& curve, double share)
{
    std::array<Spot, 4> left = curve;
    for (std::size_t count = 3; count > 0; --count)
        for (std::size_t i = 0; i < count; ++i)
            left[i] = between(left[i], left[i + 1], share);
    return left[0];
}

double distance(Spot at, Spot a, Spot b)
{
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (length < 1e-6)
        return std::hypot(at.x - a.x, at.y - a.y);
    return std::abs((b.x - a.x) * (at.y - a.y) - (b.y - a.y) * (at.x - a.x)) / length;
}

double worst_distance(const Curve& curve, std::uint32_t pieces)
{
    double worst = 0;
    for (std::uint32_t i = 0; i < pieces; ++i)
        for (const double within : {0.25, 0.5, 0.75})
            worst = std::max(worst, distance(on(curve, (i + within) / pieces), on(curve, 1.0 * i / pieces),
                                             on(curve, (i + 1.0) / pieces)));
    return worst;
}

class Trial {
public:
    explicit Trial(std::mt19937& random) : random_{random} {}

    /// The worst distance at some moments, if a curve is `depth` groups and uses deep.
    double worst(int depth)
    {
        const std::array<scene::Point, 8> points{point(), point(), point(), point(),
                                                 point(), point(), point(), point()};
        const LawPair laws = law_pair();
        const scene::Object object = filled({key(0, curve(points[0], points[1], points[2], points[3]), laws),
                                             key(40, curve(points[4], points[5], points[6], points[7]))});
        const std::vector<std::byte> bytes = written(nested(object, depth));
        const SceneView view = *SceneView::parse(bytes);
        const std::uint32_t pieces = view.symbol(0).next().object.keys().next().curve_pieces;
        if (pieces == 1024)
            return 0;
        double worst = 0;
        for (int frame = 0; frame <= 40; ++frame) {
            const Time time{frame * 1024 + static_cast<std::int32_t>(random_() % 1024)};
            Matrix matrix;
            for (const std::vector<scene::Track>& tracks : tracks_)
                matrix = matrix_at(tracks, time) * matrix;
            const Progress way = progress_between({}, Time::frame(40), time, laws);
            Curve live;
            for (std::size_t i = 0; i < 4; ++i)
                live[i] =
                    matrix * Spot{std::lerp(points[i].x / 16.0, points[i + 4].x / 16.0, share_of(way.x)),
                                  std::lerp(points[i].y / 16.0, points[i + 4].y / 16.0, share_of(way.y))};
            worst = std::max(worst, worst_distance(live, pieces));
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
        const auto x = static_cast<std::int16_t>(within(-800, 800));
        return {x, static_cast<std::int16_t>(within(-800, 800))};
    }

    LawPair law_pair()
    {
        const auto law = [this] {
            if (random_() % 2 == 0)
                return VelocityLaw{.kind = static_cast<VelocityLaw::Kind>(random_() % 4)};
            const auto y1 = static_cast<std::int16_t>(within(VelocityLaw::lowest_y, VelocityLaw::highest_y));
            const auto y2 = static_cast<std::int16_t>(within(VelocityLaw::lowest_y, VelocityLaw::highest_y));
            return VelocityLaw::bezier(3000, y1, 5000, y2);
        };
        const VelocityLaw x = law();
        return {x, law()};
    }

    std::vector<scene::Track> tracks()
    {
        const auto track = [this](Property property, std::int32_t most) {
            const std::int32_t from = within(-most, most);
            const LawPair laws = law_pair();
            return scene::Track{property,
                                {{.time = {}, .laws = laws, .value = from},
                                 {.time = Time::frame(41), .laws = {}, .value = within(-most, most)}}};
        };
        const scene::Track turn = track(Property::rotation, 65536);
        const scene::Track wide = track(Property::scale_x, 12'000);
        return {turn, wide, track(Property::scale_y, 12'000)};
    }

    /// The object in symbol 0, which is used inside of groups; tracks_ has the tracks from the inside out.
    scene::Scene nested(const scene::Object& object, int depth)
    {
        tracks_ = {tracks(), tracks()};
        const std::vector<scene::Symbol> symbols{{"curve", {item(object, tracks_[0])}}};
        scene::Item outer = item(scene::Use{0}, tracks_[1]);
        for (int group = 1; group < depth; ++group) {
            tracks_.push_back(tracks());
            outer = item(scene::Group{{outer}}, tracks_.back());
        }
        return scene_of({outer}, symbols);
    }

    std::mt19937& random_;
    std::vector<std::vector<scene::Track>> tracks_;
};

}

TEST_CASE("pieces keep within 1/32 px of their curve as it is seen, whatever moves and enlarges it")
{
    std::mt19937 random{97};
    double worst = 0;
    double typical = 0;
    for (int round = 0; round < 300; ++round) {
        const double distance = Trial{random}.worst(1 + round % 3);
        worst = std::max(worst, distance);
        typical += distance / 300;
    }
    CHECK(worst <= 1 / 32.0 + 1e-4);
    CHECK(worst > 1 / 100.0);
    CHECK(typical > 1 / 500.0); // and not much finer than it takes
}

TEST_CASE("exactly on its time a key is drawn undivided, however finely the way divides its curves")
{
    const scene::Drawing bow = curve({0, 0}, {0, 4000}, {4000, 4000}, {4000, 0});
    const scene::Drawing line =
        lines({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}, {6, 0}, {7, 0}, {8, 0}});
    const auto pieces = [](std::vector<scene::Key> keys) {
        const std::vector<std::byte> bytes = written(scene_of({item(filled(std::move(keys)))}));
        return SceneView::parse(bytes)->items().next().object.keys().next().curve_pieces;
    };
    CHECK(pieces({key(0, bow), key(10, line)}) == pieces({key(0, bow)}));
}

}
