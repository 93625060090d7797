#include "host/compiler/write/header.hpp"
#include "tests/compiled.hpp"
#include "tests/firmware/link/playback_bench.hpp"
#include "tests/firmware/settings/control_settings.hpp"

#include <doctest/doctest.h>

/// Computer, buttons and knobs steer what plays. TestPlaybackBoard checks every frame.
namespace kfast::test {

using namespace link;

namespace {

constexpr std::uint8_t tag = 42;

}

TEST_CASE("the computer steers what plays")
{
    PlaybackBench bench;
    bench.board.run_for(300);
    bench.does(Seek{.moment = Time::frame(30)});
    CHECK(bench.playing().moment == Time::frame(30));
    bench.does(Pause{});
    bench.board.run_for(100);
    const Playing paused = bench.playing();
    CHECK(paused.is_paused);
    CHECK(paused.moment >= Time::frame(30));
    CHECK(paused.moment <= Time::frame(33));
    bench.board.run_for(300);
    CHECK(bench.playing().moment == paused.moment);

    bench.does(Speed{.speed = -2 * Playhead::as_authored});
    bench.board.run_for(200);
    CHECK(bench.playing().moment == paused.moment);
    CHECK(bench.playing().speed == -2 * Playhead::as_authored);
    bench.does(Resume{});
    bench.board.run_for(200);
    CHECK(bench.playing().moment < paused.moment);
    CHECK_FALSE(bench.playing().is_paused);

    bench.does(Brightness{.brightness = 7});
    CHECK(bench.playing().brightness == 7);
    CHECK(bench.board.playback().brightness() == 7);

    bench.does(Play{.home = Home::here, .clip = {"rise"}});
    bench.board.run_for(200);
    const Playing clip = bench.playing();
    CHECK(clip.clip == Name{"rise"});
    CHECK(clip.speed == Playhead::as_authored);
    CHECK(clip.moment >= Time::frame(10));
    CHECK(clip.moment <= Time::frame(30));
    CHECK(clip.brightness == 7);
}

TEST_CASE("inputs stand where the computer says, and it is told where")
{
    PlaybackBench bench;
    bench.board.run_for(200);
    auto gaze = bench.ask<InputState>(AskInput{.input = 0});
    CHECK(gaze.name.view() == "gaze");
    CHECK(gaze.min == -1000);
    CHECK(gaze.max == 1000);
    CHECK(gaze.default_value == 0);
    CHECK(gaze.place == Time{32768});
    CHECK(bench.ask<InputState>(AskInput{.input = 1}).name.view() == "lid");
    Inputs inputs{.count = 1};
    inputs.places[0] = {.input = 0, .place = Time{100}};
    bench.does(inputs);
    bench.board.run_for(100);
    CHECK(bench.ask<InputState>(AskInput{.input = 0}).place == Time{100});
    CHECK(bench.ask<InputState>(AskInput{.input = 1}).place == Time{0});
    // Another scene has inputs of its own.
    bench.does(Play{.home = Home::start});
    bench.board.run_for(100);
    CHECK(bench.ask<InputState>(AskInput{.input = 0}).place == Time{32768});
}

TEST_CASE("a long name of an input is told as far as its letters find room")
{
    PlaybackBench bench;
    bench.board.built_in =
        compiled("kfast 1\ncanvas 8 8\ninput \"12345678901234567890123\u00e9x\" min=0 max=1\n"
                 "group g { track x input=\"12345678901234567890123\u00e9x\" { at 0 0; at 1 9 }\n"
                 "object a fill=white { rect 1 1 4 4 } }");
    bench.board.run_for(200);
    CHECK(bench.ask<InputState>(AskInput{.input = 0}).name.view() == "12345678901234567890123");
}

TEST_CASE("of the computer and a knob, the one that moved last has its way")
{
    constexpr Pin gaze = 26;
    constexpr Pin light = 27;
    constexpr Pin speed = 28;
    PlaybackBench bench{settings_with({{ControlKind::knob, ControlAction::input, gaze, {"gaze"}},
                                       {ControlKind::knob, ControlAction::brightness, light, {}},
                                       {ControlKind::knob, ControlAction::speed, speed, {}}})};
    auto& levels = bench.board.pins.levels;
    levels = {{gaze, 4095}, {light, 1600}, {speed, 2048}};
    const auto place = [&] { return bench.ask<InputState>(AskInput{.input = 0}).place.ticks; };
    bench.board.run_for(300);
    CHECK(place() == 65536);
    CHECK(bench.playing().brightness == 100);
    CHECK(bench.playing().speed == 0);

    Inputs inputs{.count = 1};
    inputs.places[0] = {.input = 0, .place = Time{5}};
    bench.does(inputs);
    bench.does(Brightness{.brightness = 9});
    bench.does(Speed{.speed = 1000});
    bench.board.run_for(100);
    CHECK(place() == 5);
    CHECK(bench.playing().brightness == 9);
    CHECK(bench.playing().speed == 1000);

    levels = {{gaze, 0}, {light, 3200}, {speed, 4095}};
    bench.board.run_for(100);
    CHECK(place() == 0);
    CHECK(bench.playing().brightness == 200);
    CHECK(bench.playing().speed > Playhead::as_authored);

    // Another scene plays as authored, its inputs stand where the knobs are, and the light stays as it was.
    bench.does(Brightness{.brightness = 11});
    play_from_ram(bench, padded_scene(2000, 1));
    bench.board.run_for(100);
    CHECK(place() == 0);
    CHECK(bench.playing().brightness == 11);
    CHECK(bench.playing().speed == Playhead::as_authored);
}

TEST_CASE("of the computer and a button, the one that moved last has its way")
{
    constexpr Pin pause = 2;
    constexpr Pin rise = 3;
    constexpr Pin lid = 4;
    PlaybackBench bench{settings_with({{ControlKind::button, ControlAction::pause, pause, {}},
                                       {ControlKind::button, ControlAction::play, rise, {"rise"}},
                                       {ControlKind::button, ControlAction::input, lid, {"lid"}}})};
    const auto press = [&](Pin pin) {
        bench.board.pins.closed[pin] = true;
        bench.board.run_for(120);
        bench.board.pins.closed[pin] = false;
        bench.board.run_for(120);
    };
    bench.board.run_for(300);
    bench.does(Pause{});
    press(pause);
    CHECK_FALSE(bench.playing().is_paused);
    press(pause);
    CHECK(bench.playing().is_paused);
    bench.does(Resume{});
    press(rise);
    CHECK(bench.playing().clip == Name{"rise"});
    bench.does(Seek{.moment = Time::frame(50)});
    bench.board.run_for(100);
    CHECK(bench.playing().clip == Name{});
    CHECK(bench.playing().moment > Time::frame(49));

    // What is held down does not count as pressed once more, but its input stands where it wants it.
    bench.board.pins.closed = {{pause, true}, {lid, true}};
    bench.board.run_for(200);
    CHECK(bench.playing().is_paused);
    play_from_ram(bench, padded_scene(2000, 1));
    bench.board.run_for(200);
    CHECK_FALSE(bench.playing().is_paused);
    CHECK(bench.ask<InputState>(AskInput{.input = 1}).place == whole_input);
}

TEST_CASE("a display that a button has switched off wakes at once, however slow its scene is")
{
    constexpr Pin sleep = 5;
    PlaybackBench bench{settings_with({{ControlKind::button, ControlAction::sleep, sleep, {}}})};
    bench.board.run_for(300);
    play_from_ram(bench, compiled("kfast 1\ncanvas 64 48 fps=1 frames=3\n"
                                  "object sun fill=yellow { circle 10 24 r=8 }\n"));
    bench.board.pins.closed[sleep] = true; // and stays so
    bench.board.run_for(5'200);
    const std::size_t shown = bench.board.frames.size();
    bench.does(Play{.home = Home::built_in});
    bench.board.run_for(500);
    CHECK(bench.board.frames.size() > shown + 5);
}

TEST_CASE("what the computer plays wakes a display that a button has switched off")
{
    constexpr Pin sleep = 5;
    PlaybackBench bench{settings_with({{ControlKind::button, ControlAction::sleep, sleep, {}}})};
    bench.board.run_for(300);
    bench.board.pins.closed[sleep] = true; // and stays so
    bench.board.run_for(200);
    const std::size_t shown = bench.board.frames.size();
    bench.board.run_for(300);
    CHECK(bench.board.frames.size() == shown);
    const Scene scene = padded_scene(2000, 1);
    play_from_ram(bench, scene);
    bench.board.run_for(300);
    CHECK(bench.board.frames.size() > shown + 5);
    CHECK(is_scene(bench.board.scene_begun(), scene));
}

TEST_CASE("when the computer goes, what it asked for is done at once")
{
    PlaybackBench bench;
    play_from_ram(bench, padded_scene(2000, 1));
    bench.does(Silence{.milliseconds = 60'000, .action = SilenceAction::start});
    bench.board.run_for(100);
    CHECK(bench.playing().home == Home::ram);
    bench.board.pipe.unplug();
    bench.board.run_for(100);
    CHECK(is_scene(bench.board.scene_begun(), bench.board.built_in));
    bench.board.pipe.plug_in();
    CHECK(bench.playing().home == Home::built_in);
}

TEST_CASE("a device that works long does not take that for silence")
{
    PlaybackBench bench;
    bench.does(Silence{.milliseconds = 100, .action = SilenceAction::hold});
    bench.board.flash_time = Microseconds{25'000};
    const Scene scene = padded_scene(4096 * 2, 1);
    bench.upload(PlaybackBench::for_slot(0, scene), scene, tag);
    CHECK_FALSE(bench.playing().is_paused);
    bench.begin(PlaybackBench::for_slot(1, padded_scene(4096, 2)), 43);
    bench.send_blocks(padded_scene(4096, 2), 43);
    bench.board.run_for(150); // with a sector to write at the end
    CHECK_FALSE(bench.playing().is_paused);
    bench.board.run_for(300);
    CHECK(bench.playing().is_paused);
}

TEST_CASE("what is asked for after a scene was told to play is about that scene")
{
    PlaybackBench bench;
    bench.board.run_for(300);
    const Scene scene = padded_scene(2000, 1);
    bench.upload(PlaybackBench::for_ram(scene), scene, tag);
    bench.send(Play{.home = Home::ram}, 1);
    Inputs inputs{.count = 1};
    inputs.places[0] = {.input = 0, .place = Time{5}};
    bench.send(inputs, 0);
    bench.send(Pause{}, 0);
    CHECK(bench.playing().home == Home::ram);
    CHECK(bench.playing().is_paused);
    CHECK(bench.ask<InputState>(AskInput{.input = 0}).place == Time{5});
}

TEST_CASE("a new computer gets no answers of the old one")
{
    PlaybackBench bench;
    bench.board.pipe.room = 0;
    for (std::uint8_t asked = 1; asked < 8; ++asked)
        bench.send(AskPlaying{}, asked);
    bench.board.run_for(100);
    bench.board.pipe.plug_in();
    bench.board.pipe.room = 4;
    bench.board.run_for(100);
    CHECK(bench.board.pipe.to_computer.empty());
}

TEST_CASE("the boot loader is entered when the answer has gone out")
{
    PlaybackBench bench;
    bench.does(EnterBootLoader{});
    CHECK_FALSE(bench.board.playback().is_to_leave(bench.board.now()));
    bench.board.run_for(100);
    CHECK(bench.board.playback().is_to_leave(bench.board.now()));
}

TEST_CASE("frames are counted")
{
    PlaybackBench bench;
    bench.board.run_for(1000);
    const auto statistics = bench.ask<Statistics>(AskStatistics{});
    CHECK(statistics.frames == bench.board.frames.size());
    CHECK(statistics.frames > 20);
    CHECK(statistics.late == 0);
    CHECK(statistics.skipped == 0);
    CHECK(statistics.coarse == 0);

    Scene curves = compiled("kfast 1\ncanvas 40 20 frames=90\nobject disc fill=white { circle 20 10 r=9 }");
    set_outline_needs(curves, {.bytes = 256, .borders = 100});
    play_from_ram(bench, curves);
    bench.board.run_for(1000);
    const auto later = bench.ask<Statistics>(AskStatistics{});
    CHECK(later.coarse > 20);
    CHECK(later.coarse < later.frames);
}

}
