#include "host/beam/beam_text.hpp"

#include <doctest/doctest.h>
#include <string>
#include <string_view>

namespace kfast::test {
namespace {

struct Reading {
    std::optional<ChosenBeam> beam;
    std::string said;
};

Reading reading_of(const std::string& text)
{
    Diagnostics diagnostics;
    const SourceText source{"my.kdl", text};
    Reading reading{read_beam_text(source, diagnostics), {}};
    for (const Diagnostic& diagnostic : diagnostics.sorted())
        reading.said += format(diagnostic, source);
    CHECK(reading.beam.has_value() == !diagnostics.has_errors());
    return reading;
}

BeamProfile read(const std::string& text)
{
    const Reading reading = reading_of(text);
    CAPTURE(reading.said);
    CHECK(reading.said.empty());
    REQUIRE(reading.beam);
    return reading.beam->profile;
}

void check_refused(const std::string& text, const std::string& place, std::string_view says,
                   std::string_view hint)
{
    const Reading reading = reading_of(text);
    CAPTURE(text);
    CAPTURE(reading.said);
    CHECK(reading.said.find("my.kdl:" + place + ": error:") != std::string::npos);
    CHECK(reading.said.find(says) != std::string::npos);
    CHECK(reading.said.find(hint) != std::string::npos);
    CHECK_FALSE(reading.beam);
}

}

TEST_CASE("a beam is a ready profile when nothing else is told")
{
    CHECK(read("beam scope") == scope_profile);
    CHECK(read("beam crt") == crt_profile);
    CHECK(read("beam galvo\n") == galvo_profile);
}

TEST_CASE("every property of a beam can be told")
{
    const BeamProfile beam = read("beam galvo rate=(kHz)12.5 lit-step=0.5 travel-step=10 corner-dwell=1 "
                                  "lit-dwell=3 arrival-dwell=4 leave-dwell=5 light-delay=6 least-refresh=25 "
                                  "resolution=512 brightness=speed park-x=-50 park-y=50 laser=#false");
    CHECK(beam == BeamProfile{.rate = 12'500,
                              .lit_step = 328,
                              .travel_step = 6554,
                              .corner_dwell = 1,
                              .lit_dwell = 3,
                              .arrival_dwell = 4,
                              .leave_dwell = 5,
                              .light_delay = 6,
                              .min_refresh = 25,
                              .resolution = 512,
                              .brightness = BeamBrightness::by_speed,
                              .park = {field_min, field_max},
                              .is_laser = false});
    CHECK(read("beam scope rate=(Hz)44100").rate == 44'100);
    CHECK(read("beam scope brightness=none").brightness == BeamBrightness::none);
    CHECK(read("beam scope brightness=level").brightness == BeamBrightness::by_level);
    CHECK(read("beam scope laser=#true").is_laser);
}

TEST_CASE("a step of nothing is a jump, and the least of more than nothing is none")
{
    CHECK(read("beam crt travel-step=0").travel_step == 0);
    CHECK(read("beam crt travel-step=0.0001").travel_step == 1);
    CHECK(read("beam crt travel-step=100").travel_step == 0xFFFF);
    CHECK(read("beam crt lit-step=0.001").lit_step == 1);
    check_refused("beam crt lit-step=0", "1:19", "out of range", "allowed: 0.001 to 100");
}

TEST_CASE("what is wrong with a beam is told with its place and what would be right")
{
    check_refused("beam galvo rate=30000", "1:17", "a frequency needs a unit", "write it like");
    check_refused("beam galvo rate=(kHz)0.9", "1:17", "out of range", "allowed: (kHz)1 to (MHz)1");
    check_refused("beam galvo rate=(pps)900", "1:17", "unknown unit \"pps\"", "Hz");
    check_refused("beam galvo corner-dwell=256", "1:25", "out of range", "allowed: 0 to 255");
    check_refused("beam galvo light-delay=1.5", "1:24", "a whole number is expected", "");
    check_refused("beam galvo resolution=100", "1:23", "a resolution is a power of two", "64, 128");
    check_refused("beam galvo resolution=32", "1:23", "out of range", "allowed: 64 to 4096");
    check_refused("beam galvo least-refresh=0", "1:26", "out of range", "allowed: 1 to 255");
    check_refused("beam galvo park-x=51", "1:19", "out of range", "allowed: -50 to 50");
    check_refused("beam galvo brightness=bright", "1:23", "\"bright\"", "level");
    check_refused("beam galvo laser=yes", "1:18", "#true or #false", "");
    check_refused("beam galvo\\\n corner-dwel=3", "2:2", "beam has no property", "corner-dwell");
    check_refused("beam gavlo", "1:6", "\"gavlo\"", "galvo");
    check_refused("beam 3", "1:6", "a word or a text", "");
    check_refused("beam", "1:1", "beam needs more values", "write beam galvo");
    check_refused("beam galvo crt", "1:12", "too many", "write beam galvo");
    check_refused("beam galvo { rate 3 }", "1:14", "beam takes no nodes inside", "write beam galvo");
    check_refused("(x)beam galvo", "1:4", "a node takes no type here", "write beam galvo");
    check_refused("panel st7789", "1:1", "a description of a beam is one node", "beam galvo");
    check_refused("beam galvo\nbeam crt", "2:1", "a description of a beam is one node", "beam galvo");
    check_refused("", "1:1", "there is no beam in this text", "beam galvo");
    check_refused("beam \"", "1:6", "", "");
}

TEST_CASE("all mistakes of a beam are told at once")
{
    const Reading reading = reading_of("beam gavlo rate=3 corner-dwell=-1");
    CHECK(reading.said.find("gavlo") != std::string::npos);
    CHECK(reading.said.find("needs a unit") != std::string::npos);
    CHECK(reading.said.find("allowed: 0 to 255") != std::string::npos);
}

TEST_CASE("a picture has time for its least points")
{
    CHECK(read("beam galvo rate=(Hz)4000 least-refresh=250").rate == 4000);
    check_refused("beam galvo rate=(Hz)4000 least-refresh=251", "1:26", "fewer than 16 points",
                  "at most 250");
    check_refused("beam scope rate=(Hz)1000 least-refresh=63", "1:26", "fewer than 16 points", "at most 62");
}

}
