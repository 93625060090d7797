#pragma once

#include "firmware/panel/panel_choice.hpp"
#include "firmware/panel/panel_reset.hpp"
#include "firmware/run/run.hpp"
#include "host/program/interruption.hpp"
#include "host/wired/panel_lines.hpp"
#include "host/wired/panel_show.hpp"
#include "host/wired/steady_clock.hpp"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace kfast {

/// A Linux computer as a board: a display with the driver `P` hangs on its lines.
template <Panel P>
class WiredBoard {
public:
    /// All of them must outlive the board.
    WiredBoard(P& panel, PanelLines& lines, const PanelShow& show)
        : panel_{panel}, lines_{lines}, show_{show},
          block_(Player::block_bytes(*SceneView::parse(show.scene), panel.size()))
    {
        for (auto& band : bands_)
            band.resize(band_rows * row_bytes(P::format, panel_.size().width));
    }

    const ShownFrames& frames() const { return frames_; }

    void wake_up()
    {
        const auto pause = [this](Microseconds time) { clock_.pause(time); };
        if (lines_.has(LineRole::reset)) {
            lines_.set(LineRole::reset, false);
            pause(panel_reset_pulse);
            lines_.set(LineRole::reset, true);
            pause(rest_after_panel_reset);
        }
        panel_.begin(pause);
    }

    void go_dark()
    {
        lines_.set(LineRole::backlight, false);
        if constexpr (PoweredPanel<P>)
            panel_.sleep([this](Microseconds time) { clock_.pause(time); });
    }

    P& panel() { return panel_; }
    Microseconds now() { return clock_.now(); }
    void sleep_until(Microseconds moment) { clock_.sleep_until(moment); }
    /// A whole picture may take seconds. Throws Interrupted.
    void listen() const { heed_interruption(); }

    std::span<const std::byte> scene_bytes() const { return show_.scene; }
    std::span<std::byte> block() { return block_; }
    std::array<std::span<std::byte>, 2> bands() { return {bands_[0], bands_[1]}; }

    bool running() const { return !was_interrupted() && frames_.shown < show_.frames.value_or(endless); }
    Playhead playhead(const SceneView&) const { return show_.timeline.playhead(); }
    void scene_started(const SceneView&) {}
    void plays(SceneState* player)
    {
        if (player != nullptr)
            show_.apply_inputs(*player);
    }

    void frame_shown(const FrameReport& report)
    {
        lines_.set(LineRole::backlight, show_.panel.brightness != 0);
        ++frames_.shown;
        frames_.left_out = report.skipped;
    }
    /// The scene was checked, and memory is as the scene says it needs.
    void fault(Error) {}

private:
    static constexpr std::uint64_t endless = ~std::uint64_t{0};
    static constexpr int band_rows = 24;

    P& panel_;
    PanelLines& lines_;
    const PanelShow& show_;
    SteadyClock clock_;
    std::vector<std::byte> block_; ///< exactly what the scene says it needs
    std::array<std::vector<std::byte>, 2> bands_;
    ShownFrames frames_;
};

}
