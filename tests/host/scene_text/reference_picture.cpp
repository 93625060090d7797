#include "tests/host/scene_text/reference_picture.hpp"

#include "host/art/geometry/affine.hpp"
#include "host/art/geometry/curves.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kfast::test {
namespace {

using art::Affine;
using scene::Vec2;

constexpr int samples = 8; ///< of a pixel, in each direction
constexpr int pieces = 24; ///< of a curve

Affine matrix(const art::Transform& transform, double time)
{
    Affine place = art::moved(transform.x.at(time), transform.y.at(time));
    if (transform.path) {
        const scene::Outline& path = transform.path->path.outlines.front();
        const Vec2 spot = art::spot_along(path, std::clamp(transform.path->share.at(time), 0.0, 1.0));
        place = art::moved(spot.x, spot.y);
    }
    return place * art::turned(transform.rotate.at(time)) *
           art::grown(transform.scale_x.at(time), transform.scale_y.at(time)) *
           art::skewed(transform.skew.at(time), transform.skew_axis.at(time)) *
           art::moved(-transform.anchor_x.at(time), -transform.anchor_y.at(time));
}

std::vector<Vec2> flat(const scene::Outline& outline, const Affine& affine)
{
    std::vector<Vec2> spots{affine.of(outline.from)};
    Vec2 from = outline.from;
    for (const scene::Curve& curve : outline.curves) {
        for (int i = 1; curve.cubic && i < pieces; ++i) {
            const double s = static_cast<double>(i) / pieces;
            const double r = 1 - s;
            spots.push_back(affine.of(r * r * r * from + 3 * r * r * s * curve.c1 + 3 * r * s * s * curve.c2 +
                                      s * s * s * curve.to));
        }
        spots.push_back(affine.of(curve.to));
        from = curve.to;
    }
    return spots;
}

struct Crossing {
    double x = 0;
    int winding = 0;
};

class Canvas {
public:
    Canvas(int width, int height)
        : width_{width * samples},
          height_{height * samples},
          colours_(static_cast<std::size_t>(width_ * height_), std::array{0.0, 0.0, 0.0})
    {
    }

    void fill(const std::vector<std::vector<Vec2>>& outlines, FillRule rule, const art::Rgb& colour)
    {
        for (int row = 0; row < height_; ++row)
            fill_row(row, crossings(outlines, (row + 0.5) / samples), rule,
                     {colour.red, colour.green, colour.blue});
    }

    Picture picture() const
    {
        Picture picture{width_ / samples, height_ / samples, {}};
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x)
                picture.pixels.push_back(mean(x * samples, y * samples));
        return picture;
    }

private:
    static std::vector<Crossing> crossings(const std::vector<std::vector<Vec2>>& outlines, double y)
    {
        std::vector<Crossing> found;
        for (const auto& spots : outlines)
            for (std::size_t i = 0; i < spots.size(); ++i) {
                const Vec2 a = spots[i];
                const Vec2 b = spots[(i + 1) % spots.size()];
                if ((a.y <= y) != (b.y <= y))
                    found.push_back({a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x), a.y < b.y ? 1 : -1});
            }
        std::ranges::sort(found, {}, &Crossing::x);
        return found;
    }

    void fill_row(int row, const std::vector<Crossing>& found, FillRule rule,
                  const std::array<double, 3>& colour)
    {
        int winding = 0;
        for (std::size_t i = 0; i + 1 < found.size(); ++i) {
            winding += found[i].winding;
            if (!is_inside(rule, winding))
                continue;
            const auto at = [&](double x) {
                return static_cast<int>(
                    std::clamp(std::ceil(x * samples - 0.5), 0.0, static_cast<double>(width_)));
            };
            for (int x = at(found[i].x); x < at(found[i + 1].x); ++x)
                colours_[static_cast<std::size_t>(row * width_ + x)] = colour;
        }
    }

    std::array<double, 3> mean(int left, int top) const
    {
        std::array<double, 3> sum{};
        for (int y = top; y < top + samples; ++y)
            for (int x = left; x < left + samples; ++x)
                for (std::size_t i = 0; i < 3; ++i)
                    sum[i] += colours_[static_cast<std::size_t>(y * width_ + x)][i] / (samples * samples);
        return sum;
    }

    int width_;
    int height_;
    std::vector<std::array<double, 3>> colours_;
};

bool is_shown(const art::Node& node, double time)
{
    return std::ranges::any_of(node.shown,
                               [time](const art::Span& span) { return time >= span.from && time < span.to; });
}

void paint(const std::vector<art::Node>& nodes, const Affine& outer, double time, Canvas& canvas)
{
    for (const art::Node& node : nodes) {
        if (!is_shown(node, time))
            continue;
        const Affine own = outer * matrix(node.transform, time);
        if (const auto* const group = std::get_if<art::Group>(&node.content)) {
            paint(group->nodes, own, time, canvas);
            continue;
        }
        const auto& shape = std::get<art::Shape>(node.content);
        std::vector<std::vector<Vec2>> outlines;
        for (const scene::Outline& outline : shape.drawing.at(time).outlines)
            outlines.push_back(flat(outline, own));
        canvas.fill(outlines, shape.fill->rule, shape.fill->colour.at(time));
    }
}

}

Picture reference_picture(const art::Document& document, double time)
{
    Canvas canvas{static_cast<int>(document.width), static_cast<int>(document.height)};
    paint(document.nodes, {}, time, canvas);
    return canvas.picture();
}

}
