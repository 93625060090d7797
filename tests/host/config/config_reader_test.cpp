#include "host/config/config_text.hpp"

#include "firmware/settings/controller_facts.hpp"

#include <doctest/doctest.h>
#include <string>
#include <string_view>

namespace kfast::test {
namespace {

const std::string whole = R"(board pico {
    panel st7789 135 240 column=52 row=40 rotation=90 colours=bgr inverted=#false brightness=0.8
    bus spi clock=(MHz)31.25
    pins clock=18 data=19 select=17 dc=16 reset=20 backlight=21 tearing=22 log=0
    clip idle
    button 12 play blink
    knob 26 place
}
)";

std::string with(std::string_view part, std::string_view other)
{
    std::string text = whole;
    return text.replace(text.find(part), part.size(), other);
}

/// All that is said about a text, and what was read from it.
struct Reading {
    std::optional<BoardSettings> settings;
    std::string said;
};

Reading reading_of(const std::string& text)
{
    Diagnostics diagnostics;
    const SourceText source{"my.kdl", text};
    Reading reading{config::read_config(source, diagnostics), {}};
    for (const Diagnostic& diagnostic : diagnostics.sorted())
        reading.said += format(diagnostic, source);
    CHECK(reading.settings.has_value() == !diagnostics.has_errors());
    return reading;
}

BoardSettings read(const std::string& text)
{
    const Reading reading = reading_of(text);
    CAPTURE(reading.said);
    CHECK(reading.said.empty());
    REQUIRE(reading.settings);
    return *reading.settings;
}

void check_reported(const Reading& reading, const std::string& where, std::string_view says)
{
    CAPTURE(reading.said);
    CHECK(reading.said.find("my.kdl:" + where) != std::string::npos);
    CHECK(reading.said.find(says) != std::string::npos);
}

void check_refused(const std::string& text, const std::string& place, std::string_view says)
{
    const Reading reading = reading_of(text);
    check_reported(reading, place + ": error:", says);
    CHECK_FALSE(reading.settings);
}

void check_warned(const std::string& text, const std::string& place, std::string_view says)
{
    const Reading reading = reading_of(text);
    check_reported(reading, place + ": warning:", says);
    CHECK(reading.settings);
}

}

TEST_CASE("a text tells everything in pixels, Hertz and GPIOs")
{
    const BoardSettings settings = read(whole);
    CHECK(settings.panel == PanelSettings{.controller = Controller::st7789,
                                          .glass = {135, 240},
                                          .column = 52,
                                          .row = 40,
                                          .rotation = Rotation::quarter,
                                          .bgr = true,
                                          .inverted = false,
                                          .tearing_effect = true,
                                          .brightness = 204});
    CHECK(settings.bus == BusKind::spi);
    CHECK(settings.bus_clock == 31'250'000);
    CHECK(settings.pins == std::array<Pin, 10>{18, 19, 17, 16, 20, 21, 22, 0, no_pin, no_pin});
    CHECK(settings.clip == StoredName{"idle"});
    CHECK(settings.controls[0] == Control{ControlKind::button, ControlAction::play, 12, {"blink"}});
    CHECK(settings.controls[1] == Control{ControlKind::knob, ControlAction::place, 26, {}});
    CHECK(settings.controls[2] == Control{});
}

TEST_CASE("buttons and knobs may be for inputs")
{
    const BoardSettings settings = read(with("play blink", "input \"wide open\"\n    knob 27 input gaze"));
    CHECK(settings.controls[0] == Control{ControlKind::button, ControlAction::input, 12, {"wide open"}});
    CHECK(settings.controls[1] == Control{ControlKind::knob, ControlAction::input, 27, {"gaze"}});
    CHECK(settings.controls[2] == Control{ControlKind::knob, ControlAction::place, 26, {}});
}

TEST_CASE("a board may lead a beam instead")
{
    const BoardSettings settings =
        read("board pico {\n    beam galvo rate=(kHz)40\n    bus dac clock=(MHz)18\n"
             "    pins clock=2 data=3 select=4 ldac=5 blank=6 log=0\n"
             "    button 12 arm\n}\n");
    BeamProfile beam = galvo_profile;
    beam.rate = 40'000;
    CHECK(settings.beam == beam);
    CHECK(settings.panel == PanelSettings{});
    CHECK(settings.bus == BusKind::dac);
    CHECK(settings.bus_clock == 18'000'000);
    CHECK(settings.pin(PinRole::ldac) == 5);
    CHECK(settings.pin(PinRole::blank) == 6);
    CHECK(settings.controls[0] == Control{ControlKind::button, ControlAction::arm, 12, {}});

    const BoardSettings scope =
        read("board pico { beam scope; bus dac; pins clock=2 data=3 select=4 ldac=5 blank=6 }");
    CHECK(scope.beam == scope_profile);
    CHECK(scope.bus_clock == 20'000'000);
}

TEST_CASE("a beam and its bus go together")
{
    const std::string pins = "\n    pins clock=18 data=19 select=17 ldac=16 blank=20\n";
    const std::string beam = "board pico {\n    beam scope\n    bus dac";
    check_refused(with("panel st7789 135 240 column=52 row=40 rotation=90 colours=bgr inverted=#false "
                       "brightness=0.8\n",
                       "\n"),
                  "1:1", "neither a panel nor a beam");
    check_refused("board pico {\n    panel st7789\n    beam scope\n    bus dac" + pins + "}", "3:5",
                  "a panel or a beam, not both");
    check_refused("board pico {\n    panel st7789\n    bus dac" + pins + "}", "3:9", "leads a beam");
    check_refused("board pico {\n    beam scope\n    bus spi\n    pins clock=18 data=19 dc=16\n}", "3:9",
                  "write bus dac");
    check_refused(beam + "\n    pins clock=18 data=19 select=17 ldac=16\n}", "4:5",
                  "dac needs a pin for blank");
    check_refused(beam + " clock=(MHz)25" + pins + "}", "3:13", "(MHz)20");
    check_refused("board pico {\n    beam scope rate=(kHz)900\n    bus dac" + pins + "}", "2:16",
                  "cannot carry 900000 points a second");
    check_refused(beam + pins + "    button 12 arm\n}", "5:15", "the beam is no laser");
    check_refused("board pico {\n    beam scop\n    bus dac" + pins + "}", "2:10", "scope");
    check_refused("board pico {\n    beam scope lit-step=0\n    bus dac" + pins + "}", "2:25", "");
}

TEST_CASE("what is left out is as in the usual module")
{
    const BoardSettings tft = read("board pico { panel st7735; bus spi; pins clock=18 data=19 dc=16 }");
    CHECK(tft.panel == facts_of(Controller::st7735).default_value);
    CHECK(tft.bus_clock == 15'150'000);
    CHECK(tft.pin(PinRole::reset) == no_pin);
    CHECK(tft.clip == StoredName{});
    CHECK(tft.controls[0].kind == ControlKind::none);

    const BoardSettings round = read("board pico { panel gc9a01; bus spi; pins clock=18 data=19 dc=16 }");
    CHECK(round.bus_clock == 62'500'000); // the chip's most, not the display's

    const BoardSettings oled = read("board pico { panel ssd1306; bus i2c; pins clock=5 data=4 }");
    CHECK(oled.bus_clock == 400'000);
    CHECK(oled.i2c_address == 0x3C);
}

TEST_CASE("another glass than the usual one begins in the corner of the memory unless it is told where")
{
    const auto panel = [](const std::string& words) {
        return read("board pico { panel " + words + "; bus spi; pins clock=18 data=19 dc=16 }").panel;
    };
    CHECK(panel("st7735 128 160").column == 2);
    CHECK(panel("st7735 128 128").column == 0);
    CHECK(panel("st7735 128 128").row == 0);
    CHECK(panel("st7735 128 128").bgr);
    CHECK(panel("st7735 80 160 column=26 row=1").column == 26);
}

TEST_CASE("the tearing effect is used when it is wired, unless it is told otherwise")
{
    CHECK(read(whole).panel.tearing_effect);
    CHECK_FALSE(read(with(" tearing=22", "")).panel.tearing_effect);
    CHECK_FALSE(read(with("brightness=0.8", "tearing=#false")).panel.tearing_effect);
    check_refused(
        with(" tearing=22", "").replace(0, 0, "").replace(whole.find("brightness=0.8"), 14, "tearing=#true"),
        "4:5", "there is no pin for the tearing effect");
}

TEST_CASE("parts may come in any order, and controls keep theirs")
{
    const BoardSettings settings =
        read("board pico { knob 27 speed; pins clock=18 data=19 dc=16; button 1 sleep; "
             "bus spi clock=(Hz)1000000; panel ili9341 }");
    CHECK(settings.bus_clock == 1'000'000);
    CHECK(settings.panel.controller == Controller::ili9341);
    CHECK(settings.controls[0].action == ControlAction::speed);
    CHECK(settings.controls[1].action == ControlAction::sleep);
}

TEST_CASE("mistakes are told with their place and the remedy")
{
    check_refused(with("board pico", "board pica"), "1:7", "did you mean \"pico\"?");
    check_refused(with("board pico", "board pico2"), "1:7",
                  "a Pico 2 (RP2350, Cortex-M33) is not supported yet");
    check_refused(with("panel", "pannel"), "2:5", "did you mean \"panel\"?");
    check_refused(with("panel", "pannel"), "1:1", "add \"panel st7789");
    check_refused(with("st7789", "st7798"), "2:11", "did you mean \"st7789\"?");
    check_refused(with("st7789", "ssd1322"), "2:11", "kfast fit alone knows it");
    check_refused(with("st7789", "sh1106"), "2:11", "take one with an SSD1306");
    check_refused(with("135 240", "135"), "2:18", "a panel has a width and a height");
    check_refused(with("135 240", "135 0"), "2:22", "allowed: 1 to 4096");
    check_refused(with("135 240", "135 240 1"), "2:26", "too many for panel");
    check_refused(with("column=52", "colum=52"), "2:26", "did you mean \"column\"?");
    check_refused(with("column=52", "column=5.2"), "2:33", "a whole number");
    check_refused(with("rotation=90", "rotation=45"), "2:52", "write 0, 90, 180 or 270");
    check_refused(with("rotation=90", "rotation=360"), "2:52", "write 0, 90, 180 or 270");
    check_refused(with("=bgr", "=gbr"), "2:63", "did you mean \"bgr\"?");
    check_refused(with("#false", "no"), "2:76", "#true or #false");
    check_refused(with("0.8", "80"), "2:94", "allowed: 0 to 1");
    check_refused(with("bus spi", "bus spy"), "3:9", "did you mean \"spi\"?");
    check_refused(with("(MHz)31.25", "31.25"), "3:19", "a frequency needs a unit");
    check_refused(with("clock=18", "sck=18"), "4:10", "here it is called clock: write clock=");
    check_refused(with("clock=18", "clok=18"), "4:10", "did you mean \"clock\"?");
    check_refused(with("clock=18", "clock=GP18"), "4:16", "write 18 for GP18");
    check_refused(with("clock=18", "clock=30"), "4:16", "allowed: 0 to 29");
    check_refused(with("clip idle", "clip"), "5:5", "write clip NAME");
    check_refused(with("clip idle", "clip \"a name of twenty-five byte\""), "5:10", "up to 24 bytes");
    check_refused(with("clip idle", "clip \"\""), "5:10", "cannot be empty");
    check_refused(with("clip idle", "clip a; clip b"), "5:13", "\"clip\" stands here already, on line 5");
    check_refused(with("play blink", "plya blink"), "6:15", "did you mean \"play\"?");
    check_refused(with("play blink", "speed"), "6:15", "speed is not for a button");
    check_refused(with("play blink", "pause blink"), "6:21", "pause is for no clip or input");
    check_refused(with("play blink", "pause 5"), "6:21", "pause is for no clip or input");
    check_refused(with("play blink", ""), "6:5", "write button 12 play");
    check_refused(with("12 play", "play 12"), "6:12", "the number of a GPIO");
    check_refused(with("place", "pause"), "7:13", "allowed: place, speed, brightness, input");
    check_refused(with("place", "input"), "7:13", "knob 2 does not say for which input it is");
    check_refused(with("place", "input"), "7:13", "write the name that it has in the scene: input NAME");
    check_refused(with("play blink", "input"), "6:15", "button 1 does not say for which input it is");
    check_refused(with("place", "input=gaze"), "7:5", "or knob 26 input NAME");
    check_refused(with("place", "input gaze open"), "7:24", "too many for knob");
    check_refused(with("place", "inptu gaze"), "7:13", "did you mean \"input\"?");
    check_refused(with("place", "input \"a name of twenty-five byte\""), "7:19",
                  "a board holds names of inputs up to 24 bytes");
    check_refused(with("place", "input \"\""), "7:19", "cannot be empty");
}

TEST_CASE("rules of the board are told at the place that breaks them")
{
    check_refused(with("135 240", "240 400"), "2:18", "does not lie within the 240 x 320 pixels of st7789");
    check_refused(with("135 240 column=52 row=40", "320 240"), "2:18", "240 320, and rotation=90 or 270");
    check_refused(with("bus spi", "bus i2c"), "3:9", "write bus spi or bus parallel");
    check_refused(with("31.25", "80"), "3:13", "allowed: (kHz)1.923 to (MHz)62.5");
    check_refused(with("(MHz)31.25", "(Hz)5"), "3:13", "so slow");
    check_refused(with(" dc=16", ""), "4:5", "add dc=");
    check_refused(with("clock=18", "clock=17"), "4:10", "use one of GP2, GP6, GP10, GP14, GP18, GP22");
    check_refused(with("clock=18", "clock=10"), "4:19", "data can be on GP11, GP15, GP27");
    check_refused(with("reset=20", "reset=21"), "4:52", "GP21 is taken twice: by reset and by backlight");
    check_refused(with("reset=20", "reset=21"), "4:52", "free: GP1 to GP11, GP13 to GP15, GP20, GP27, GP28");
    check_refused(with("reset=20", "reset=25"), "4:43", "GP25 is not on the edge of a Pico");
    check_refused(with("log=0", "log=1"), "4:76", "GP1 cannot carry a log");
    check_refused(with("button 12", "button 18"), "6:12", "GP18 is taken twice: by clock and by button 1");
    check_refused(with("knob 26", "knob 15"), "7:10", "use one of GP26 to GP28");
    check_refused("board pico { panel ssd1306 rotation=90; bus i2c address=0x78; pins clock=5 data=4 }",
                  "1:28", "write rotation=0 or 180");
    check_refused("board pico { panel ssd1306 rotation=90; bus i2c address=0x78; pins clock=5 data=4 }",
                  "1:49", "without the bit for reading and writing it is 0x3C");
    check_refused("board pico { panel ssd1306 120 60; bus i2c; pins clock=5 data=4 }", "1:28",
                  "let the glass be a multiple of 8 x 8");
    check_refused("board pico { panel st7789; bus parallel; pins data=16 clock=8 dc=9 }", "1:47",
                  "let data= be one of 0 to 15");
    check_refused("board pico { panel st7789; bus parallel; pins data=0 clock=7 dc=9 }", "1:47",
                  "GP7 is taken twice: by clock and by data (D0 to D7 on GP0 to GP7)");
}

TEST_CASE("a clock above the rating and an address of no use are only warned of")
{
    check_warned("board pico {\npanel ili9341\nbus spi clock=(MHz)40\npins clock=18 data=19 dc=16\n}", "3:9",
                 "faster than the maker of ili9341 allows, (MHz)10");
    check_warned("board pico {\npanel st7789\nbus spi address=0x3D\npins clock=18 data=19 dc=16\n}", "3:9",
                 "only i2c has addresses");
}

TEST_CASE("texts that are no settings are told so")
{
    check_refused("", "1:1", "there is no board in this text");
    check_refused("kfast 1\ncanvas 240 240", "1:1", "a text of settings is one node");
    check_refused(whole + "board pico {}", "9:1", "one node");
    check_refused("board pico {", "1:12", "closing }");
    check_refused("board", "1:1", "board needs more values");
    check_refused("board desk { core cortex-m0 clock=(MHz)1 }", "1:14", "a board has no node \"core\"");
}

TEST_CASE("a ninth control finds no room")
{
    std::string nine = "board pico {\npanel st7789\nbus spi\npins clock=18 data=19 dc=16\n";
    for (int i = 0; i < 9; ++i)
        nine += "button " + std::to_string(i) + " pause\n";
    check_refused(nine + '}', "13:1", "at most 8 buttons and knobs");
}

TEST_CASE("all mistakes are told at once")
{
    const std::string said =
        reading_of(
            "board pico { panel st7788 rotation=1 size=1; bus spy clock=1; pins mosi=1 dc=99; knob a b; x }")
            .said;
    for (const char* what :
         {"st7788", "turned by quarters", "\"size\"", "\"spy\"", "a frequency needs a unit", "called data",
          "allowed: 0 to 29", "number of a GPIO", "unknown value", "no node \"x\""}) {
        CAPTURE(what);
        CHECK(said.find(what) != std::string::npos);
    }
    const std::string broken =
        reading_of(
            "board pico { panel gc9a01 320 240; bus i2c clock=(MHz)2; pins clock=1 data=1; knob 25 place }")
            .said;
    for (const char* what : {"cannot be driven by i2c", "does not lie within", "so fast", "taken twice",
                             "GP25 is not", "GP1 cannot carry i2c data"}) {
        CAPTURE(what);
        CHECK(broken.find(what) != std::string::npos);
    }
}

}
