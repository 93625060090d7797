// Turns one drawing into another, both in plain arrays, and writes a strip of the in-betweens: morph
// >morph.svg
#include "core/math/flatten.hpp"
#include "core/pose/equalize.hpp"
#include "core/scene/drawing_view.hpp"
#include "core/time/velocity_law.hpp"

#include <array>
#include <cstdint>
#include <cstdio>

namespace {

using kfast::DrawingView, kfast::Point, kfast::Segment, kfast::Fraction, kfast::StrokeView;

constexpr Point at(int x, int y) { return {kfast::Fixed::pixels(x), kfast::Fixed::pixels(y)}; }

// A drop of water: one closed stroke.
constexpr std::array outline{
    Segment{Segment::Kind::cubic, at(21, 44), at(8, 82), at(72, 82), at(59, 44)},
    Segment{.from = at(59, 44), .to = at(40, 8)},
    Segment{.from = at(40, 8), .to = at(21, 44)},
};
constexpr std::array drop{StrokeView{outline}};

// A house: two strokes of straight lines.
constexpr std::array walls{at(16, 36), at(16, 72), at(64, 72), at(64, 36)};
constexpr std::array roof{at(72, 40), at(64, 33), at(64, 14), at(56, 14), at(56, 26), at(40, 12), at(8, 40)};
constexpr std::array house{StrokeView{walls}, StrokeView{roof}};

void print(Point point) { std::printf(" %.2f,%.2f", point.x.raw() / 65536.0, point.y.raw() / 65536.0); }

void draw_between(DrawingView from, DrawingView to, Fraction time)
{
    const auto x = kfast::progress(kfast::VelocityLaw::accelerate_decelerate, time);
    const auto y = kfast::progress(kfast::VelocityLaw::constant, time);
    kfast::EqualizedPair pair{from, to};
    while (const std::uint32_t segments = pair.next_stroke()) {
        std::printf("<polyline points='");
        for (std::uint32_t i = 0; i < segments; ++i) {
            const kfast::Pair<Segment> both = pair.next_segment();
            const Segment live = kfast::tween(both.a, both.b, x, y);
            if (i == 0)
                print(live.from);
            kfast::flatten(live, kfast::pieces_for(live), print);
        }
        std::printf("'/>\n");
    }
}

}

int main()
{
    constexpr int last = 6;
    std::printf("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 %d 80' fill='none' stroke='#0077b6' "
                "stroke-width='3' stroke-linecap='round' stroke-linejoin='round'>\n",
                80 * (last + 1));
    for (int step = 0; step <= last; ++step) {
        std::printf("<g transform='translate(%d)'>\n", 80 * step);
        draw_between(DrawingView{drop}, DrawingView{house},
                     Fraction::ratio(static_cast<unsigned>(step), last));
        std::printf("</g>\n");
    }
    std::printf("</svg>\n");
}
