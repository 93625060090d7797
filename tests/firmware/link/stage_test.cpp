#include "host/drawing_reports.hpp"
#include "tests/compiled.hpp"
#include "tests/firmware/link/staged_board.hpp"

#include <doctest/doctest.h>

#include <random>

/// What plays on a board, seen through its link and on its display. StagedBoard checks every frame.
namespace kfast::test {

using namespace link;

namespace {

constexpr std::uint8_t tag = 42;

std::size_t needed(const Scene& scene) { return Player::block_bytes(*SceneView::parse(scene), small_panel); }

}

TEST_CASE("a board plays its built-in scene and tells so")
{
    StagedBench bench;
    bench.board.run_for(500);
    const Playing playing = bench.playing();
    CHECK(playing.is_playing);
    CHECK_FALSE(playing.is_paused);
    CHECK(playing.home == Home::built_in);
    CHECK(playing.slot == no_slot);
    CHECK(playing.brightness == 255);
    CHECK(playing.inputs == 2);
    CHECK(playing.canvas == Size{64, 48});
    CHECK(playing.length == Time::frame(60));
    CHECK(playing.speed == Playhead::as_authored);
    CHECK(playing.moment > Time{0});
    const auto capabilities = bench.ask<Capabilities>(Hello{});
    CHECK(capabilities.panel == small_panel);
    CHECK(capabilities.block_bytes == 40'000);
    CHECK(capabilities.ram_bytes == 20'000);
    CHECK(capabilities.serial.view() == "E6");
    CHECK(bench.ask<Names>(AskNames{}).board.view() == "board");
    CHECK(bench.board.panel().beginnings == 1);
}

TEST_CASE("a board answers while its panel begins")
{
    StagedBench bench;
    bench.send(AskPlaying{}, 1);
    bench.board.run_for(50);
    REQUIRE(bench.board.pipe.to_computer.size() == 1);
    CHECK(message_of<Playing>(Report{bench.board.pipe.to_computer.front()})->is_playing);
    CHECK(bench.board.frames.empty());
}

TEST_CASE("the chosen slot plays at the start, and the built-in scene if it cannot")
{
    const Scene scene = padded_scene(3000, 1);
    for (const bool is_damaged : {false, true}) {
        StagedBench bench;
        REQUIRE(put(bench.board.slots, 2, "eyes", scene) == Status::ok);
        REQUIRE(bench.board.slots.choose(2) == Status::ok);
        if (is_damaged)
            bench.board.flash.damage(small_places.pool + bench.board.slots.entry(2).offset + 50);
        bench.board.run_for(300);
        CHECK(bench.board.scenes_begun == 1);
        CHECK(is_scene(bench.board.scene_begun(), is_damaged ? bench.board.built_in : scene));
        CHECK(bench.playing().slot == (is_damaged ? no_slot : 2));
    }
}

TEST_CASE("a board without a scene shows a card, and can be talked to")
{
    StagedBench bench;
    bench.board.built_in.assign(2000, std::byte{0xFF});
    bench.board.run_for(300);
    CHECK(bench.board.faults == std::vector{Error::bad_magic});
    CHECK_FALSE(bench.playing().is_playing);
    CHECK(bench.refusal(AskInput{}) == Verdict{Status::nothing_plays});
    CHECK(bench.refusal(Play{.home = Home::built_in}) == Verdict{Status::no_scene});
    bench.does(Play{.home = Home::start});
    bench.board.run_for(100);
    CHECK_FALSE(bench.playing().is_playing);
    bench.does(Pause{});
    bench.does(Seek{});
    const Scene scene = padded_scene(2000, 1);
    play_from_ram(bench, scene);
    bench.board.run_for(50);
    CHECK(is_scene(bench.board.scene_begun(), scene));
    CHECK(bench.playing().home == Home::ram);
    bench.does(Silence{.milliseconds = 100, .action = SilenceAction::start});
    bench.board.run_for(200);
    CHECK(bench.board.faults.size() == 3);
}

TEST_CASE("a scene in RAM plays within a tenth of a second, on a panel that is not begun again")
{
    StagedBench bench;
    bench.board.built_in =
        compiled("kfast 1\ncanvas 8 8 fps=1 frames=60\nobject a fill=white { rect 1 1 4 4 }");
    bench.board.run_for(1500);
    const Scene scene = padded_scene(2048, 1);
    bench.upload(StagedBench::for_ram(scene), scene, tag);
    const Microseconds asked = bench.board.now();
    bench.does(Play{.home = Home::ram});
    bench.board.run_for(20);
    CHECK(is_scene(bench.board.scene_begun(), scene));
    CHECK((bench.board.begun_at - asked).count < 100'000);
    CHECK(bench.board.panel().beginnings == 1);
}

TEST_CASE("scenes in RAM follow one another, and the old one plays until the new one does")
{
    StagedBench bench;
    bench.board.run_for(300);
    for (std::uint32_t seed = 1; seed < 12; ++seed) {
        const Scene scene = padded_scene(1500 + seed * 177, seed);
        const int begun = bench.board.scenes_begun;
        const std::size_t frames = bench.board.frames.size();
        bench.upload(StagedBench::for_ram(scene), scene, static_cast<std::uint8_t>(seed));
        bench.board.run_for(100);
        CHECK(bench.board.frames.size() > frames);
        CHECK(bench.board.scenes_begun == begun);
        bench.does(Play{.home = Home::ram});
        bench.board.run_for(100);
        CHECK(is_scene(bench.board.scene_begun(), scene));
    }
}

/// A block in which one scene finds room, with its player, and not two.
struct TightBench : StagedBench {
    Scene first = padded_scene(4000, 1);
    Scene second = padded_scene(4000, 2);

    TightBench() : StagedBench{{}, (needed(padded_scene(4000, 1)) + 7000) / 4 * 4} {}

    std::size_t frames() const { return board.frames.size(); }
    /// Whether frames are drawn.
    bool plays()
    {
        const std::size_t before = frames();
        board.run_for(200);
        return frames() > before + 2;
    }
};

TEST_CASE("what plays from RAM gives way to another scene, and the picture holds meanwhile")
{
    TightBench bench;
    play_from_ram(bench, bench.first);
    CHECK(bench.plays());
    bench.begin(StagedBench::for_ram(bench.second), 43);
    CHECK_FALSE(bench.plays());
    CHECK_FALSE(bench.playing().is_playing);
    bench.send_blocks(bench.second, 43);
    bench.does(Commit{}, 43);
    bench.does(Play{.home = Home::ram});
    CHECK(bench.plays());
    CHECK(is_scene(bench.board.scene_begun(), bench.second));
}

TEST_CASE("when nothing comes of it the scene of the start plays")
{
    for (const bool is_cancelled : {false, true}) {
        TightBench bench;
        play_from_ram(bench, bench.first);
        bench.begin(StagedBench::for_ram(bench.second), 43);
        CHECK_FALSE(bench.plays());
        if (is_cancelled)
            bench.does(Cancel{}, 43);
        else
            bench.board.run_for(3100);
        CHECK(bench.plays());
        CHECK(bench.playing().home == Home::built_in);
    }
}

TEST_CASE("a scene from flash that needs all memory gives way, and plays again if nothing comes of it")
{
    const Scene scene = padded_scene(4000, 1);
    for (const bool is_unplugged : {false, true}) {
        StagedBench bench{{}, (needed(scene) + 1000) / 4 * 4};
        REQUIRE(put(bench.board.slots, 5, "eyes", scene) == Status::ok);
        bench.does(Play{.home = Home::slot, .slot = 5});
        bench.board.run_for(100);
        const Scene small = padded_scene(1100, 2);
        bench.begin(StagedBench::for_ram(small), tag);
        bench.board.run_for(100);
        CHECK_FALSE(bench.playing().is_playing);
        if (is_unplugged) {
            bench.board.pipe.plug_in();
        } else { // which is accepted, but needs more than is left
            bench.send_blocks(small, tag);
            bench.does(Commit{}, tag);
            CHECK(bench.refusal(Play{.home = Home::ram}) == Verdict{Status::block_too_small});
        }
        bench.board.run_for(100);
        CHECK(bench.playing().slot == 5);
        CHECK(is_scene(bench.board.scene_begun(), scene));
    }
}

TEST_CASE("what gave way to a scene in RAM that nobody plays, plays again")
{
    const Scene scene = padded_scene(4000, 1);
    const std::array<std::function<void(StagedBench&)>, 4> ways{
        [](StagedBench& bench) { bench.does(Cancel{}, tag); },
        [](StagedBench& bench) { bench.board.pipe.plug_in(); },
        [](StagedBench& bench) { bench.board.run_for(4'000); },
        [](StagedBench& bench) {
            CHECK(bench.refusal(Play{.home = Home::ram, .clip = {"none"}}) == Verdict{Status::no_such_clip});
            bench.does(Cancel{}, tag);
        },
    };
    for (const auto& go_away : ways) {
        StagedBench bench{{}, (needed(scene) + 1000) / 4 * 4};
        REQUIRE(put(bench.board.slots, 5, "eyes", scene) == Status::ok);
        bench.does(Play{.home = Home::slot, .slot = 5});
        bench.board.run_for(100);
        const Scene small = padded_scene(1100, 2);
        bench.upload(StagedBench::for_ram(small), small, tag);
        bench.board.run_for(1'000);
        CHECK_FALSE(bench.playing().is_playing);
        go_away(bench);
        bench.board.run_for(100);
        CHECK(bench.playing().slot == 5);
        CHECK(is_scene(bench.board.scene_begun(), scene));
    }
}

TEST_CASE("a scene in RAM that plays stays when its upload is cancelled, and after a while")
{
    StagedBench bench;
    const Scene scene = padded_scene(2000, 1);
    play_from_ram(bench, scene);
    bench.does(Cancel{}, tag);
    bench.board.run_for(5'000);
    CHECK(bench.playing().home == Home::ram);
    CHECK(is_scene(bench.board.scene_begun(), scene));
    bench.does(Play{.home = Home::here});
    bench.board.run_for(100);
    CHECK(bench.playing().home == Home::ram);
}

TEST_CASE("a scene from flash that gave way is not written over, whatever becomes of its slot")
{
    const Scene scene = padded_scene(4000, 1);
    StagedBench bench{{}, (needed(scene) + 1000) / 4 * 4};
    REQUIRE(put(bench.board.slots, 5, "eyes", scene) == Status::ok);
    REQUIRE(put(bench.board.slots, 0, "all the rest", padded_scene((pool_sectors - 1) * sector_bytes, 2)) ==
            Status::ok);
    bench.does(Play{.home = Home::slot, .slot = 5});
    bench.board.run_for(300);
    bench.begin(StagedBench::for_ram(padded_scene(1100, 2)), tag);
    bench.does(EraseSlot{.slot = 5});
    CHECK(bench.refusal(StagedBench::for_slot(1, scene), 43) == Verdict{Status::no_room, 0});
    bench.board.run_for(200);
    CHECK(bench.playing().slot == 5);
}

TEST_CASE("a scene from flash has the whole block, whatever lies in RAM")
{
    const Scene large = compiled("kfast 1\ncanvas 64 48 frames=60\nobject sun fill=yellow {" + [] {
        std::string circles;
        for (int i = 0; i < 40; ++i)
            circles += " circle 10 " + std::to_string(4 + i % 30) + " r=5\n";
        return circles;
    }() + "}");
    const std::size_t block = (needed(large) + 3) / 4 * 4;
    StagedBench bench{{}, block};
    bench.board.run_for(300);
    REQUIRE(put(bench.board.slots, 0, "large", large) == Status::ok);
    const Scene small = padded_scene(2000, 1);
    REQUIRE(needed(small) + 2000 < block);
    bench.upload(StagedBench::for_ram(small), small, tag);
    bench.does(Play{.home = Home::slot, .slot = 0});
    bench.board.run_for(100);
    CHECK(is_scene(bench.board.scene_begun(), large));
    CHECK(bench.refusal(Play{.home = Home::ram}) == Verdict{Status::nothing_in_ram});
    CHECK(bench.playing().slot == 0);
}

TEST_CASE("playing from a slot goes on while the slot is replaced")
{
    StagedBench bench;
    bench.board.run_for(300);
    const Scene first = padded_scene(9000, 1);
    bench.upload(StagedBench::for_slot(1, first), first, tag);
    bench.does(Play{.home = Home::slot, .slot = 1});
    bench.board.run_for(100);
    bench.board.flash_time = Microseconds{5'000};
    for (std::uint32_t seed = 2; seed < 8; ++seed) {
        const Scene next = padded_scene(9000 + seed, seed);
        bench.upload(StagedBench::for_slot(1, next), next, static_cast<std::uint8_t>(seed));
        CHECK(is_scene(bench.board.scene_begun(), first));
    }
    CHECK(bench.ask<Statistics>(AskStatistics{}).late > 0);
    bench.does(Play{.home = Home::slot, .slot = 1});
    bench.board.run_for(100);
    CHECK(is_scene(bench.board.scene_begun(), padded_scene(9007, 7)));
}

TEST_CASE("a text is what the computer told last, until another scene plays")
{
    StagedBench bench;
    bench.board.built_in = compiled(
        "kfast 1\ncanvas 64 48\ninput gaze\ninput t kind=text glyphs=\"0-9\" max=3 default=\"7\"\n"
        "object o stroke=white { text input=t at=\"4,40\" size=32; track x input=gaze { at 0 0; at 1 9 } }");
    bench.board.run_for(200);
    const auto state = bench.ask<InputState>(AskInput{.input = 1});
    CHECK(state.takes == InputKind::text);
    CHECK(state.name.view() == "t");
    CHECK(state.most == 3);
    const auto picture = [&bench] {
        const auto bytes = bench.board.panel().picture();
        return std::vector(bytes.begin(), bytes.end());
    };
    const auto tell = [&bench](std::string_view words) {
        Text text{.input = 1, .length = static_cast<std::uint8_t>(words.size())};
        std::ranges::copy(std::as_bytes(std::span{words}), text.bytes.begin());
        bench.does(text);
    };
    const auto usual = picture();
    tell("12");
    bench.board.run_for(100);
    const auto told = picture();
    CHECK(told != usual);
    tell("9");
    tell("7");
    bench.board.run_for(100);
    CHECK(picture() == usual);
    tell("12");
    bench.board.run_for(100);
    CHECK(picture() == told);
    CHECK(bench.refusal(Text{.input = 0}) == Verdict{Status::no_text});
    bench.does(Play{.home = Home::start});
    bench.board.run_for(100);
    CHECK(picture() == usual);
}

TEST_CASE("drawings are shown in the frame after their last report, whole and nothing else")
{
    StagedBench bench;
    const Scene scene = compiled("kfast 1\ncanvas 64 48 fps=50 frames=9\ninput n\n"
                                 "input plot kind=drawing points=33 { line 1 1 9 5 }\n"
                                 "object o stroke=white live=plot { track y input=n { at 0 0; at 1 2 } }\n"
                                 "object p fill=red { rect 0 0 2 2; key 0 x=0; key 9 x=9 }");
    bench.upload(StagedBench::for_ram(scene), scene, 7);
    bench.does(Play{.home = Home::ram});
    bench.board.run_for(100);
    const auto state = bench.ask<InputState>(AskInput{.input = 1});
    CHECK(state.name.view() == "plot");
    CHECK(state.takes == InputKind::drawing);
    std::mt19937 random{3};
    for (std::uint8_t number = 0; number < 40; ++number) {
        ToldDrawing drawing(1);
        for (auto points = random() % 34; points > 0; --points) {
            const auto x = static_cast<std::int16_t>(random() % 300);
            drawing[0].push_back({x, static_cast<std::int16_t>(random() % 150)});
        }
        for (const Report& report : drawing_reports(drawing, 1, number)) {
            bench.board.pipe.to_device.push_back(report.bytes);
            // in the midst of frames; each is checked
            bench.board.run_for(static_cast<std::uint32_t>(1 + random() % 7));
        }
        bench.board.run_for(100);
        std::erase_if(drawing, [](const auto& stroke) { return stroke.empty(); });
        CHECK(bench.board.drawing(1) == drawing);
    }
    CHECK(bench.refusal(Drawing{.which = 0}) == Verdict{Status::no_drawing});
    CHECK(bench.refusal(Drawing{.which = 2}) == Verdict{Status::no_such_input, 2});
    bench.does(Drawing{.which = 1});
    bench.does(Play{.home = Home::start});
}

/// Everything at random: whatever comes, every frame is one of a whole scene (StagedBoard), the device
/// answers in the end, and nothing holds the picture for ever.
TEST_CASE("whatever a computer does, whole scenes are shown")
{
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        CAPTURE(seed);
        std::mt19937 random{seed};
        const auto below = [&](std::uint32_t limit) { return static_cast<std::uint32_t>(random() % limit); };
        StagedBench bench{{}, (needed(padded_scene(4000, 1)) + 1000 + below(8000)) / 4 * 4};
        bench.board.pipe.room = 4;
        const auto act = [&] {
            const auto which = static_cast<std::uint8_t>(1 + below(3));
            switch (below(16)) {
            case 0:
            case 1:
            case 2: {
                const Scene scene = padded_scene(900 + below(4000), below(5));
                bench.send(below(2) ? StagedBench::for_ram(scene)
                                    : StagedBench::for_slot(static_cast<std::uint8_t>(below(3)), scene),
                           which);
                if (below(4) != 0)
                    bench.send_blocks(scene, which);
                if (below(4) != 0)
                    bench.send(Commit{}, which);
                return;
            }
            case 3:
                return bench.send(Commit{}, which);
            case 4:
                return bench.send(Cancel{}, which);
            case 5:
            case 6:
            case 7:
                return bench.send(Play{.home = static_cast<Home>(below(5)),
                                       .slot = static_cast<std::uint8_t>(below(3)),
                                       .clip = below(3) == 0 ? Name{"rise"} : Name{}},
                                  which);
            case 8:
                return bench.send(EraseSlot{.slot = static_cast<std::uint8_t>(below(3))}, which);
            case 9:
                return bench.send(ChooseSlot{.slot = static_cast<std::uint8_t>(below(3))}, which);
            case 10:
                return bench.send(Seek{.moment = Time{static_cast<std::int32_t>(below(200'000)) - 100'000}},
                                  0);
            case 11:
                return bench.send(Speed{.speed = static_cast<std::int32_t>(below(400'000)) - 200'000}, 0);
            case 12: {
                Inputs inputs{.count = 1};
                inputs.places[0] = {.input = static_cast<std::uint8_t>(below(2)),
                                    .place = Time{static_cast<std::int32_t>(below(65'537))}};
                return bench.send(inputs, 0);
            }
            case 13:
                return bench.send(Silence{.milliseconds = static_cast<std::uint16_t>(below(100)),
                                          .action = static_cast<SilenceAction>(below(2))},
                                  which);
            case 14:
                return below(5) == 0 ? bench.board.pipe.plug_in() : bench.send(AskPlaying{}, which);
            default:
                return below(2) ? bench.send(Pause{}, 0) : bench.send(Resume{}, 0);
            }
        };
        bench.board.computer = [&] {
            if (below(20) == 0)
                act();
            while (below(2) && !bench.board.pipe.to_computer.empty())
                bench.board.pipe.to_computer.pop_front();
        };
        bench.board.run_for(8000);
        bench.board.computer = [] {};
        bench.board.run_for(4000);
        CHECK(bench.board.pipe.to_device.empty());
        bench.board.pipe.plug_in();
        bench.board.pipe.room = 100;
        CHECK((bench.playing().is_playing || !bench.board.stage().lent_ram().empty()));
        play_from_ram(bench, padded_scene(1000, 1));
        bench.board.run_for(100);
        CHECK(bench.playing().home == Home::ram);
    }
}

}
