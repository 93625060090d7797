#include "host/player/received_drawing.hpp"
#include "tests/compiled.hpp"
#include "tests/firmware/link/playback_bench.hpp"

#include <doctest/doctest.h>

#include <random>

/// Texts and drawings that a computer tells. TestPlaybackBoard checks every frame.
namespace kfast::test {

using namespace link;

TEST_CASE("a text is what the computer told last, until another scene plays")
{
    PlaybackBench bench;
    bench.board.built_in =
        compiled("kfast 1\ncanvas 64 48\ninput gaze\ninput t kind=text glyphs=\"0-9\" max=3 default=\"7\"\n"
                 "object o stroke=white { text input=t at=\"4,40\" size=32 font=hershey-sans; track x "
                 "input=gaze { at 0 0; at 1 9 } }");
    bench.board.run_for(200);
    const auto state = bench.ask<InputState>(AskInput{.input = 1});
    CHECK(state.takes == InputKind::text);
    CHECK(state.name.view() == "t");
    CHECK(state.max == 3);
    const auto picture = [&bench] {
        const auto bytes = bench.board.panel().picture();
        return std::vector(bytes.begin(), bytes.end());
    };
    const auto deliver = [&bench](std::string_view words) {
        Text text{.input = 1, .length = static_cast<std::uint8_t>(words.size())};
        std::ranges::copy(std::as_bytes(std::span{words}), text.bytes.begin());
        bench.does(text);
    };
    const auto default_value = picture();
    deliver("12");
    bench.board.run_for(100);
    const auto changed = picture();
    CHECK(changed != default_value);
    deliver("9");
    deliver("7");
    bench.board.run_for(100);
    CHECK(picture() == default_value);
    deliver("12");
    bench.board.run_for(100);
    CHECK(picture() == changed);
    CHECK(bench.refusal(Text{.input = 0}) == StatusWithNumber{Status::no_text});
    bench.does(Play{.home = Home::start});
    bench.board.run_for(100);
    CHECK(picture() == default_value);
}

TEST_CASE("drawings are shown in the frame after their last report, whole and nothing else")
{
    PlaybackBench bench;
    const Scene scene = compiled("kfast 1\ncanvas 64 48 fps=50 frames=9\ninput n\n"
                                 "input plot kind=drawing points=33 { line 1 1 9 5 }\n"
                                 "object o stroke=white live=plot { track y input=n { at 0 0; at 1 2 } }\n"
                                 "object p fill=red { rect 0 0 2 2; key 0 x=0; key 9 x=9 }");
    bench.upload(PlaybackBench::for_ram(scene), scene, 7);
    bench.does(Play{.home = Home::ram});
    bench.board.run_for(100);
    const auto state = bench.ask<InputState>(AskInput{.input = 1});
    CHECK(state.name.view() == "plot");
    CHECK(state.takes == InputKind::drawing);
    std::mt19937 random{3};
    for (std::uint8_t number = 0; number < 40; ++number) {
        ReceivedDrawing drawing(1);
        for (auto points = random() % 34; points > 0; --points) {
            const auto x = static_cast<std::int16_t>(random() % 300);
            drawing[0].push_back({x, static_cast<std::int16_t>(random() % 150)});
        }
        for (const Report& report : drawing_reports(drawing, 1, number)) {
            bench.board.pipe.to_device.push_back(report);
            // in the midst of frames; each is checked
            bench.board.run_for(static_cast<std::uint32_t>(1 + random() % 7));
        }
        bench.board.run_for(100);
        std::erase_if(drawing, [](const auto& stroke) { return stroke.empty(); });
        CHECK(bench.board.drawing(1) == drawing);
    }
    CHECK(bench.refusal(Drawing{.which = 0}) == StatusWithNumber{Status::no_drawing});
    CHECK(bench.refusal(Drawing{.which = 2}) == StatusWithNumber{Status::no_such_input, 2});
    bench.does(Drawing{.which = 1});
    bench.does(Play{.home = Home::start});
}

}
