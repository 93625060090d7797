#include "host/beam/beam_text.hpp"

#include "host/beam/profile_choice.hpp"
#include "tests/rounds.hpp"

#include <doctest/doctest.h>
#include <limits>
#include <random>
#include <string>

namespace kfast::test {
namespace {

std::optional<BeamProfile> read(const std::string& text)
{
    Diagnostics diagnostics;
    const auto beam = read_beam_text({"my.kdl", text}, diagnostics);
    return beam ? std::optional{beam->profile} : std::nullopt;
}

template <class Number>
Number any(std::mt19937& random, Number min = std::numeric_limits<Number>::min(),
           Number max = std::numeric_limits<Number>::max())
{
    return static_cast<Number>(std::uniform_int_distribution<std::int64_t>{min, max}(random));
}

BeamProfile random_profile(std::mt19937& random)
{
    BeamProfile beam;
    beam.rate = any<std::uint32_t>(random, 4096, 1'000'000);
    beam.lit_step = any<std::uint16_t>(random, 1);
    beam.travel_step = any<std::uint16_t>(random);
    for (std::uint8_t BeamProfile::*const wait :
         {&BeamProfile::corner_dwell, &BeamProfile::lit_dwell, &BeamProfile::arrival_dwell,
          &BeamProfile::leave_dwell, &BeamProfile::light_delay})
        beam.*wait = any<std::uint8_t>(random);
    beam.min_refresh = any<std::uint8_t>(random, 1);
    beam.resolution = static_cast<std::uint16_t>(64 << any<int>(random, 0, 6));
    beam.brightness = static_cast<BeamBrightness>(any<int>(random, 0, 2));
    beam.park = {any<std::int16_t>(random), any<std::int16_t>(random)};
    beam.is_laser = any<int>(random, 0, 1) == 1;
    return beam;
}

}

TEST_CASE("a text of a beam tells every property, on lines that can be read")
{
    BeamProfile beam = galvo_profile;
    beam.rate = 12'500;
    CHECK(beam_text(beam, "    ") ==
          R"(beam galvo rate=(kHz)12.5 lit-step=1 travel-step=5 corner-dwell=8 lit-dwell=2 arrival-dwell=6 \
        leave-dwell=4 light-delay=4 least-refresh=20 resolution=128 brightness=level park-x=0 \
        park-y=0 laser=#true)");
    CHECK(beam_text(scope_profile).starts_with("beam scope rate=(kHz)100 lit-step=0.586 travel-step=0 "));
    CHECK(beam_text(crt_profile).starts_with("beam crt rate=(kHz)100 lit-step=0.39 travel-step=3.125 "));
}

TEST_CASE("a beam's text is read as the same beam")
{
    for (const ProfileChoice& choice : profile_choices())
        CHECK(read(beam_text(choice.profile)) == choice.profile);
    std::mt19937 random{9};
    for (int round = 0; round < rounds(2000); ++round) {
        const BeamProfile beam = random_profile(random);
        CAPTURE(beam_text(beam));
        CHECK(read(beam_text(beam)) == beam);
    }
}

}
