#include "tests/firmware/link/playback_bench.hpp"
#include "tests/rounds.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

/// Everything at random: whatever comes, every frame is one of a whole scene (TestPlaybackBoard), the device
/// answers in the end, and nothing holds the picture for ever.
namespace kfast::test {

using namespace link;

namespace {

class RandomComputer {
public:
    explicit RandomComputer(std::uint32_t seed) : random_{seed} {}

    std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(random_() % limit); }

    /// Sends a message now and then, and takes some answers.
    void take_turn(PlaybackBench& bench)
    {
        if (below(20) == 0)
            act(bench);
        while (below(2) && !bench.board.pipe.to_computer.empty())
            bench.board.pipe.to_computer.pop_front();
    }

private:
    std::uint8_t any_slot() { return static_cast<std::uint8_t>(below(3)); }

    void act(PlaybackBench& bench)
    {
        const auto which = static_cast<std::uint8_t>(1 + below(3));
        switch (below(16)) {
        case 0:
        case 1:
        case 2:
            return send_scene(bench, which);
        case 3:
            return bench.send(Commit{}, which);
        case 4:
            return bench.send(Cancel{}, which);
        case 5:
        case 6:
        case 7:
            return bench.send(Play{.home = static_cast<Home>(below(5)),
                                   .slot = any_slot(),
                                   .clip = below(3) == 0 ? Name{"rise"} : Name{}},
                              which);
        case 8:
            return bench.send(EraseSlot{.slot = any_slot()}, which);
        case 9:
            return bench.send(ChooseSlot{.slot = any_slot()}, which);
        case 10:
            return bench.send(Seek{.moment = Time{static_cast<std::int32_t>(below(200'000)) - 100'000}}, 0);
        case 11:
            return bench.send(Speed{.speed = static_cast<std::int32_t>(below(400'000)) - 200'000}, 0);
        case 12:
            return move_input(bench);
        case 13:
            return bench.send(Silence{.milliseconds = static_cast<std::uint16_t>(below(100)),
                                      .action = static_cast<SilenceAction>(below(2))},
                              which);
        case 14:
            return below(5) == 0 ? bench.board.pipe.plug_in() : bench.send(AskPlaying{}, which);
        default:
            return below(2) ? bench.send(Pause{}, 0) : bench.send(Resume{}, 0);
        }
    }

    /// Or a part of one.
    void send_scene(PlaybackBench& bench, std::uint8_t which)
    {
        const Scene scene = padded_scene(900 + below(4000), below(5));
        bench.send(below(2) ? PlaybackBench::for_ram(scene) : PlaybackBench::for_slot(any_slot(), scene),
                   which);
        if (below(4) != 0)
            bench.send_blocks(scene, which);
        if (below(4) != 0)
            bench.send(Commit{}, which);
    }

    void move_input(PlaybackBench& bench)
    {
        Inputs inputs{.count = 1};
        inputs.places[0] = {.input = static_cast<std::uint8_t>(below(2)),
                            .place = Time{static_cast<std::int32_t>(below(65'537))}};
        bench.send(inputs, 0);
    }

    std::mt19937 random_;
};

}

TEST_CASE("whatever a computer does, whole scenes are shown")
{
    const auto seeds = static_cast<std::uint32_t>(std::max(rounds(40), 5)); // sanitizers see some as well
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        CAPTURE(seed);
        RandomComputer computer{seed};
        PlaybackBench bench{{}, (needed(padded_scene(4000, 1)) + 1000 + computer.below(8000)) / 4 * 4};
        bench.board.pipe.room = 4;
        bench.board.computer = [&] { computer.take_turn(bench); };
        bench.board.run_for(8000);
        bench.board.computer = [] {};
        bench.board.run_for(4000);
        CHECK(bench.board.pipe.to_device.empty());
        bench.board.pipe.plug_in();
        bench.board.pipe.room = 100;
        CHECK((bench.playing().is_playing || !bench.board.playback().leased_ram().empty()));
        play_from_ram(bench, padded_scene(1000, 1));
        bench.board.run_for(100);
        CHECK(bench.playing().home == Home::ram);
    }
}

}
