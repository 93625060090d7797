#pragma once

#include "firmware/run/board.hpp"
#include "firmware/run/run.hpp"
#include "tests/bench/metered_player.hpp"
#include "tests/bench/null_panel.hpp"
#include "tests/bench/phase.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast::bench {

/// One frame of the steady loop.
struct FrameCost {
    std::uint32_t number = 0;
    PhaseCosts phases{};
    Traffic traffic;
};

/// Of each of the two bands, on every target.
inline constexpr std::size_t band_bytes = 4096;

/// The memory that a scene is played in.
struct Workspace {
    std::span<std::byte> block;
    std::array<std::span<std::byte>, 2> bands;
};

/// Frames until the picture comes round again.
inline std::uint32_t frames_in_turn(const PlayRange& stretch)
{
    const std::int32_t ticks = stretch.length().ticks * (stretch.loop == Loop::ping_pong ? 2 : 1);
    return static_cast<std::uint32_t>((ticks + Time::ticks_per_frame - 1) / Time::ticks_per_frame);
}

/// Runs the firmware's loop for two turns of the scene and tells `report(const FrameCost&)` what the frames
/// of the second one cost. Its clock stands still while a frame is drawn, so that no frame is left out.
template <class Meter, class Report>
class BenchBoard {
public:
    BenchBoard(const PlayRange& stretch, Size panel, const Workspace& workspace, Meter& meter, Report report)
        : turn_{frames_in_turn(stretch)}, workspace_{workspace}, meter_{meter}, panel_{meter}, report_{report}
    {
        panel_.set_size(panel);
    }

    NullPanel<Meter>& panel() { return panel_; }
    Microseconds now() const { return now_; }
    void sleep_until(Microseconds moment) { now_ = moment; }
    std::span<const std::byte> scene_bytes() { return {}; } // the scene is parsed already
    std::span<std::byte> block() { return workspace_.block; }
    std::array<std::span<std::byte>, 2> bands() { return workspace_.bands; }
    bool running() const { return shown_ < 2 * turn_; }
    void scene_started(const SceneView&) {}
    void fault(Error) {}

    /// What it has cost to make the player, from the first frame on.
    std::uint32_t load() const { return load_; }

    void frame_shown(FrameReport)
    {
        meter_.enter(Phase::elsewhere);
        const FrameCost cost{shown_ % turn_, meter_.take(), panel_.take_traffic()};
        load_ += cost.phases[static_cast<std::size_t>(Phase::load)];
        if (shown_ >= turn_)
            report_(cost);
        ++shown_;
        meter_.enter(Phase::send);
    }

private:
    std::uint32_t turn_;
    Workspace workspace_;
    Meter& meter_;
    NullPanel<Meter> panel_;
    Report report_;
    Microseconds now_;
    std::uint32_t shown_ = 0;
    std::uint32_t load_ = 0;
};

/// As the scene says, but what would end comes round again: only then is there a steady loop.
inline PlayRange steady_stretch(const SceneView& scene)
{
    PlayRange stretch = play_range_of(scene);
    if (stretch.loop == Loop::once)
        stretch.loop = Loop::repeat;
    return stretch;
}

/// Plays two turns of `scene` on a panel of its canvas's size. Fails as Player::create does; else what it has
/// cost to make the player.
template <class Meter, class Report>
Result<std::uint32_t> measure(const SceneView& scene, const Workspace& workspace, Meter& meter, Report report)
{
    const Size panel = scene.canvas();
    meter.enter(Phase::load);
    auto player = Player::create(scene, panel, Fit::contain, workspace.block);
    meter.enter(Phase::elsewhere);
    if (!player)
        return player.error();

    const PlayRange stretch = steady_stretch(scene);
    BenchBoard board{stretch, panel, workspace, meter, report};
    MeteredPlayer metered{*player, meter};
    meter.enter(Phase::send);
    play(board, metered, Playhead{stretch, scene.events()}, {scene.frame_rate(), board.now()});
    meter.enter(Phase::elsewhere);
    return board.load();
}

}
