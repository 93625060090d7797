#include "host/preview/board/fit_check.hpp"

#include "core/player.hpp"
#include "host/fit/wording.hpp"
#include "host/preview/board/previewed_board.hpp"
#include "tests/host/preview/named_scene.hpp"

#include <chrono>
#include <doctest/doctest.h>
#include <thread>

namespace kfast::test {
namespace {

using Verdict = FitLine::Verdict;

constexpr const char* bouncing = "kfast 1\ncanvas 240 240 frames=20\n"
                                 "object ball fill=red { key 0 x=0; key 20 x=80; circle 60 60 r=40 }\n";

std::vector<FitLine> lines_of(const NamedScene& scene, const fit::Target& board)
{
    if (board.beam)
        return fit_lines(fit::beam_fit(scene.view(), board, 0), board);
    return fit_lines(fit::fit_report({.scene = scene.view(), .item_names = scene.names(), .target = board}),
                     board);
}

bool has(const std::vector<FitLine>& lines, const std::string& beginning, Verdict verdict)
{
    return std::ranges::any_of(lines, [&](const FitLine& line) {
        return line.text.starts_with(beginning) && line.verdict == verdict;
    });
}

std::vector<FitLine> waited_for(const FitCheck& check)
{
    while (!check.lines())
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
    return {check.lines()->begin(), check.lines()->end()};
}

}

TEST_CASE("a scene that fits has good lines, and says what limits it")
{
    const NamedScene scene{bouncing};
    const fit::Target board = previewed_board({.size = {240, 240}});
    const std::vector<FitLine> lines = lines_of(scene, board);
    CHECK(lines[1] == FitLine{"pico, 125 MHz"});
    CHECK(lines[2] == FitLine{"st7789 240x240"});
    CHECK(has(lines, "scene   " + std::to_string(scene.view().size()) + " B of 256 KiB", Verdict::good));
    CHECK(has(lines,
              "RAM     " + fit::memory_text(Player::block_bytes(scene.view(), {240, 240})) + " of 89 KiB",
              Verdict::good));
    CHECK(has(lines, "besides, the firmware has", Verdict::neutral));
    CHECK(has(lines, "flash   1.75 MiB of 2 MiB", Verdict::neutral));
    CHECK(has(lines, "speed   ", Verdict::good));
    CHECK(has(lines, "limit   the ", Verdict::neutral));
    CHECK(has(lines, "ball takes ", Verdict::neutral));
    CHECK(lines.front() == FitLine{"fits", Verdict::good});
}

TEST_CASE("a scene that does not fit says why, below the figures")
{
    const NamedScene scene{bouncing};
    fit::Target board = previewed_board({.size = {240, 240}});
    board.clock = 1e6;
    board.ram = 20'000;
    const std::vector<FitLine> lines = lines_of(scene, board);
    CHECK(has(lines, "RAM     ", Verdict::bad));
    CHECK(has(lines, "speed   ", Verdict::bad));
    CHECK(has(lines, "RAM: ", Verdict::bad));
    CHECK(has(lines, "speed: every second frame takes", Verdict::bad));
    CHECK(lines.front() == FitLine{"does not fit", Verdict::bad});
    CHECK(lines[3].text.starts_with("speed   "));
    CHECK(lines[4].text.starts_with("RAM     "));
    CHECK(lines[5].text.starts_with("scene   "));
}

TEST_CASE("a scene that fits though some of its pictures are late says how many")
{
    const NamedScene scene{
        "kfast 1\ncanvas 240 240 frames=30\n"
        "object a fill=red { key 0 law=hold { rect 0 0 9 9 }; key 15 { rect 0 0 240 240 } }\n"};
    fit::Target board = previewed_board({.size = {240, 240}});
    board.bus.clock = 20e6;
    const std::vector<FitLine> lines = lines_of(scene, board);
    CHECK(lines[0] == FitLine{"fits"});
    CHECK(lines[1] == FitLine{"but 2 of 30 pictures late"});
}

TEST_CASE("the panel that is shown is the one that is judged, and a beam is one")
{
    const NamedScene scene{bouncing};
    const fit::Target mono = previewed_board({.size = {128, 32}, .controller = "ssd1306"});
    CHECK(mono.display.format == fit::display_named("ssd1306")->format);
    CHECK(mono.display.size == Size{128, 32});
    const fit::Target beam = previewed_board({.size = {480, 480}, .beam = scope_profile});
    REQUIRE(beam.beam.has_value());
    const std::vector<FitLine> lines = lines_of(scene, beam);
    CHECK(has(lines, "busiest ", Verdict::neutral));
    CHECK(lines.front() == FitLine{"fits", Verdict::good});
}

TEST_CASE("a check comes to the same lines on its thread, while other scenes are drawn")
{
    const NamedScene scene{bouncing};
    const fit::Target board = previewed_board({.size = {240, 240}});
    const std::vector<FitLine> expected = lines_of(scene, board);
    const FitCheck check{scene.bytes(), scene.names(), board, Fit::contain};
    CHECK(lines_of(scene, board) == expected); // at the same time
    CHECK(waited_for(check) == expected);
}

TEST_CASE("a report that nobody wants any more stops after a picture, and a check with it")
{
    const NamedScene scene{"kfast 1\ncanvas 240 240 frames=4000\n"
                           "object ball fill=red { key 0 x=0; key 4000 x=80; circle 60 60 r=40 }\n"};
    std::stop_source stop;
    stop.request_stop();
    const fit::Target panel = previewed_board({.size = {240, 240}});
    CHECK_THROWS_AS(
        fit::fit_report(
            {.scene = scene.view(), .item_names = scene.names(), .target = panel, .stop = stop.get_token()}),
        fit::FitStopped);
    const fit::Target beam = previewed_board({.size = {240, 240}, .beam = scope_profile});
    CHECK_THROWS_AS(fit::beam_fit(scene.view(), beam, 0, stop.get_token()), fit::FitStopped);
    const FitCheck abandoned{scene.bytes(), scene.names(), panel, Fit::contain};
}

}
