#include "host/beam/beam_deflection.hpp"

#include "host/beam/beam_screen.hpp"
#include "host/beam/profile_choice.hpp"

#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

namespace kfast::test {
namespace {

constexpr auto unheard = [](BeamPlace, BeamPlace) {};

DeflectedBeam at_rest(const BeamDeflection& deflection, std::uint32_t rate, FieldPoint at)
{
    DeflectedBeam beam{deflection, rate};
    beam.put(at);
    return beam;
}

}

TEST_CASE("a beam stays where it is told to be, and gets where it is told to go")
{
    for (const ProfileChoice& choice : profile_choices()) {
        CAPTURE(choice.name);
        DeflectedBeam beam = at_rest(display_of(choice.name).deflection, choice.profile.rate, {100, -200});
        beam.pull({100, -200}, unheard);
        CHECK(beam.place().x == 100);
        CHECK(beam.place().y == -200);
        for (int i = 0; i < 200; ++i)
            beam.pull({30000, 20000}, unheard);
        CHECK(beam.place().x == doctest::Approx(30000).epsilon(1e-6));
        CHECK(beam.place().y == doctest::Approx(20000).epsilon(1e-6));
    }
}

TEST_CASE("a scope is there within a point, a monitor within ten")
{
    const auto distance_after = [](std::string_view name, FieldPoint way, int points) {
        DeflectedBeam beam = at_rest(display_of(name).deflection, 100'000, {});
        for (int i = 0; i < points; ++i)
            beam.pull(way, unheard);
        return std::abs(beam.place().x - way.x);
    };
    CHECK(distance_after("scope", {6553, 0}, 1) < 16);
    CHECK(distance_after("crt", {2048, 0}, 10) < 16);
    CHECK(distance_after("crt", {2048, 0}, 1) > 200);
    CHECK(distance_after("galvo", {2048, 0}, 1) > 200);
}

TEST_CASE("a mirror follows an even way four points behind, as the profile galvo tells its light")
{
    DeflectedBeam beam = at_rest(display_of("galvo").deflection, galvo_profile.rate, {-30000, 0});
    const double step = galvo_profile.lit_step;
    double target = -30000;
    while (target + step < 30000) {
        target += step;
        beam.pull({static_cast<std::int16_t>(target), 0}, unheard);
    }
    // It is pulled to a place for the whole time of a point: on the average the place is told half a point
    // ago.
    CHECK((target - beam.place().x) / step + 0.5 == doctest::Approx(galvo_profile.light_delay).epsilon(0.05));
}

TEST_CASE("a beam is not faster than its top speed")
{
    const BeamDeflection slow{.bandwidth = 50e3, .damping = 1, .top_speed = 100};
    DeflectedBeam beam = at_rest(slow, 100'000, {-30000, 30000});
    const double longest = 100.0 * field_side / 100'000;
    for (int i = 0; i < 50; ++i) {
        const BeamPlace before = beam.place();
        beam.pull({30000, 30000}, unheard);
        CHECK(beam.place().x - before.x <= longest * 1.0001);
        CHECK(beam.place().x - before.x > longest * 0.9);
        CHECK(beam.place().y == 30000);
    }
}

TEST_CASE("the steps of a beam are one way")
{
    DeflectedBeam beam = at_rest(display_of("crt").deflection, 100'000, {});
    BeamPlace last = beam.place();
    int steps = 0;
    beam.pull({5000, -5000}, [&](BeamPlace from, BeamPlace to) {
        CHECK(from.x == last.x);
        CHECK(from.y == last.y);
        last = to;
        ++steps;
    });
    CHECK(steps == beam.steps());
    CHECK(last.x == beam.place().x);
    CHECK(last.x > 0);
}

}
