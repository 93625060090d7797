#include "core/beam/beam_player.hpp"
#include "core/player.hpp"
#include "firmware/panel/panel_choice.hpp"
#include "firmware/run/run.hpp"
#include "firmware/settings/controller_facts.hpp"
#include "tests/demand.hpp"
#include "tests/fuzz/memory.hpp"
#include "tests/fuzz/played.hpp"
#include "tests/fuzz/sealed.hpp"
#include "tests/fuzz/told_inputs.hpp"
#include "tests/known.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace kfast::test {
namespace {

constexpr std::uint32_t frames = 6;
constexpr std::size_t most_lent = std::size_t{1} << 20;

/// What a board has whatever its display, and what runs on it: a few frames, each with other inputs.
class Board {
public:
    Board(std::span<const std::byte> scene, std::size_t block_bytes)
        : scene_{scene}, block_{std::min(block_bytes, most_lent)}
    {
    }

    Microseconds now() const { return now_; }
    void sleep_until(Microseconds moment) { now_ = moment; }
    void linger_until(Microseconds moment) { now_ = moment; }
    std::span<const std::byte> scene_bytes() const { return scene_; }
    std::span<std::byte> block() { return block_.bytes(); }
    bool running() const { return shown_ < frames && !has_fault_; }
    void scene_started(const SceneView&) {}
    void frame_shown(FrameReport report)
    {
        demand(report.time >= Time{});
        ++shown_;
        if (player_ != nullptr)
            tell_inputs(*player_, shown_);
    }
    void fault(Error error) { has_fault_ = !error_text(error).empty(); }
    void plays(SceneState* player) { player_ = player; }

private:
    std::span<const std::byte> scene_;
    Memory block_;
    Microseconds now_;
    std::uint32_t shown_ = 0;
    bool has_fault_ = false;
    SceneState* player_ = nullptr;
};

/// The wires to a display: all that goes over them was written.
class Bus {
public:
    void command(std::span<const std::byte> bytes) { demand_known(bytes); }
    void parameters(std::span<const std::byte> bytes) { demand_known(bytes); }
    void start_data(std::span<const std::byte> bytes) { demand_known(bytes); }
    bool busy() const { return false; }
};

template <class P>
class BoardWithPanel : public Board {
public:
    BoardWithPanel(std::span<const std::byte> scene, std::size_t block_bytes, P& panel)
        : Board{scene, block_bytes}, panel_{panel}
    {
    }

    P& panel() { return panel_; }
    std::array<std::span<std::byte>, 2> bands() { return {bands_[0].bytes(), bands_[1].bytes()}; }

private:
    P& panel_;
    std::array<Memory, 2> bands_{Memory{400}, Memory{400}};
};

/// A vector display.
class PretendBeam {
public:
    explicit PretendBeam(const BeamProfile& profile) : profile_{profile} {}

    const BeamProfile& profile() const { return profile_; }
    std::uint32_t room() const { return 500; }
    bool takes_picture() const { return true; }
    void plot(std::span<const BeamPoint> points)
    {
        demand_known(points);
        plotted_ += points.size();
        demand(plotted_ <= room());
    }
    void show() { demand(std::exchange(plotted_, 0) != 0); }
    void park() { plotted_ = 0; }

private:
    BeamProfile profile_;
    std::size_t plotted_ = 0;
};

class BoardWithBeam : public Board {
public:
    BoardWithBeam(std::span<const std::byte> scene, std::size_t block_bytes, const BeamProfile& profile)
        : Board{scene, block_bytes}, beam_{profile}
    {
    }

    PretendBeam& beam() { return beam_; }

private:
    PretendBeam beam_;
};

/// As large as the scene needs; of what is no scene, some.
std::size_t block_for(std::span<const std::byte> bytes, Size panel, const BeamProfile& beam)
{
    const auto scene = SceneView::parse(bytes);
    return scene ? std::max(Player::block_bytes(*scene, panel), BeamPlayer::block_bytes(*scene, beam)) : 1000;
}

/// On a small glass of the controller that `seed` chooses, and by the beam that it chooses.
void run_scene_on_boards(std::span<const std::byte> bytes, std::uint32_t seed)
{
    PanelSettings settings = controller_facts[seed % controller_count].default_value;
    settings.glass = {32, 16};
    settings.rotation = static_cast<Rotation>(seed % 4);
    const BeamProfile beam = way_of(seed).beam;
    const std::size_t block_bytes = block_for(bytes, settings.size(), beam);
    Bus bus;
    with_panel(bus, settings, [&](auto& panel) {
        BoardWithPanel board{bytes, block_bytes, panel};
        run(board);
    });
    BoardWithBeam board{bytes, block_bytes, beam};
    run(board);
}

}
}

/// Any bytes at all, as they are and sealed: a board plays them, or shows why it cannot.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace kfast;
    const auto bytes = std::as_bytes(std::span{data, size});
    test::run_scene_on_boards(bytes, static_cast<std::uint32_t>(size));
    if (size >= test::sealed_from)
        test::run_scene_on_boards(test::sealed(bytes), static_cast<std::uint32_t>(size));
    return 0;
}
