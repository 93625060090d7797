#include "host/scene_text/drawings/steady_form.hpp"

#include "host/art/geometry/drawing.hpp"
#include "tests/host/art/random_document.hpp"

#include <cmath>
#include <doctest/doctest.h>

namespace kfast::test {
namespace {

using scene::Outline;
using scene::Vec2;

double distance_of_ends(const Outline& one, const Outline& other)
{
    double max = 0;
    for (std::size_t i = 0; i < one.curves.size(); ++i)
        max = std::max(max, scene::distance(one.curves[i].to, other.curves[i].to));
    return max;
}

/// As few different places as there can be, so that points meet.
Outline crowded_outline(RandomArt& random)
{
    const auto spot = [&] { return Vec2{random.integer(0, 1) * 40.0, random.integer(0, 1) * 0.125}; };
    Outline outline{spot(), {}, random.chance(0.5)};
    for (int i = random.integer(1, 7); i > 0; --i)
        outline.curves.push_back(random.chance(0.7) ? scene::line_to(spot())
                                                    : scene::cubic_to(spot(), spot(), spot()));
    if (outline.closed)
        outline.curves.back().to = outline.from;
    return outline;
}

}

TEST_CASE("no segment is lost by rounding, and points stay where they are")
{
    RandomArt random{5};
    for (int round = 0; round < 20'000; ++round) {
        const Outline before = crowded_outline(random);
        art::Drawing drawing{{before}};
        art::Drawing* const drawings[] = {&drawing};
        scene_text::keep_segments(drawings);
        const Outline& after = drawing.outlines.front();
        REQUIRE(scene::quantized(after).segments.size() == before.curves.size());
        // So many may lie in one place.
        CHECK(distance_of_ends(before, after) < 0.07 * static_cast<double>(before.curves.size()));
    }
}

TEST_CASE("a gap that closes in one drawing is drawn in all")
{
    art::Drawing open{{{{0, 0}, {scene::line_to({10, 0}), scene::line_to({10, 10})}, true}}};
    art::Drawing shut{{{{0, 0}, {scene::line_to({10, 0}), scene::line_to({0, 0})}, true}}};
    art::Drawing* const drawings[] = {&open, &shut};
    scene_text::keep_segments(drawings);
    CHECK(scene::quantized(open.outlines.front()).segments.size() == 3);
    CHECK(scene::quantized(shut.outlines.front()).segments.size() == 3);
}

TEST_CASE("an open outline that ends where it begins stays open")
{
    art::Drawing drawing{
        {{{0, 0}, {scene::line_to({10, 0}), scene::line_to({10, 10}), scene::line_to({0, 0})}, false}}};
    scene_text::keep_open(drawing);
    const Vec2 end = drawing.outlines.front().curves.back().to;
    CHECK(end.x == doctest::Approx(0.0625));
    CHECK(end.y == doctest::Approx(0.0625));
}

}
