#pragma once

#include "core/player.hpp"
#include "firmware/panel/panel_choice.hpp"
#include "firmware/panel/panel_reset.hpp"
#include "firmware/run/board.hpp"
#include "firmware/settings/panel_settings.hpp"
#include "host/picture/frame_source.hpp"
#include "host/simulator/simulated_bus.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace kfast {

/// A frame as the panel showed it.
struct ShownFrame {
    Time time;
    std::vector<std::string> events; ///< passed since the frame before
    Frame picture;                   ///< upright, decoded from the bus
};

/// A board that exists in memory: the firmware's loop and its driver `P` run on it against a model of the
/// controller. Its clock stands still while a frame is drawn, so that no frame is ever late.
template <Panel P>
class SimulatedBoard {
public:
    /// Runs for `frames` frames. `scene`'s bytes must outlive the board; `P` drives the controller that
    /// `settings` name.
    SimulatedBoard(std::span<const std::byte> scene, const PanelSettings& settings, std::size_t frames)
        : scene_{scene}, settings_{settings}, frames_wanted_{frames}
    {
        if (const auto view = SceneView::parse(scene))
            block_.resize(Player::block_bytes(*view, panel_.size()));
        for (auto& band : bands_)
            band.resize(band_rows * row_bytes(P::format, panel_.size().width));
        model_->reset(clock_.elapsed());
        clock_.pass(rest_after_panel_reset);
    }
    SimulatedBoard(const SimulatedBoard&) = delete;

    const std::vector<ShownFrame>& frames() const { return frames_; }
    /// What the panel shows now, upright.
    Frame picture() const { return seen_upright(model_->picture(), settings_.rotation); }
    /// Why the scene cannot be played.
    const std::optional<Error>& error() const { return error_; }
    /// What driver or loop did wrong on the wires.
    std::optional<std::string> bus_error() const { return bus_.error() ? bus_.error() : model_->error(); }

    P& panel() { return panel_; }
    Microseconds now() const { return clock_.now(); }
    void sleep_until(Microseconds moment)
    {
        if (!reached(now(), moment))
            clock_.pass(moment - now());
    }

    std::span<const std::byte> scene_bytes() const { return scene_; }
    std::span<std::byte> block() { return block_; }
    std::array<std::span<std::byte>, 2> bands() { return {bands_[0], bands_[1]}; }

    bool running() const { return frames_.size() < frames_wanted_; }
    void scene_started(const SceneView&) {}
    void event_passed(const EventView& event) { passed_.emplace_back(event.name); }
    void frame_shown(FrameReport report)
    {
        frames_.push_back({report.time, std::exchange(passed_, {}), picture()});
    }
    void fault(Error error) { error_ = error; }

private:
    static constexpr int band_rows = 8;

    std::span<const std::byte> scene_;
    PanelSettings settings_;
    std::vector<std::byte> block_; ///< exactly what the scene says it needs
    std::array<std::vector<std::byte>, 2> bands_;
    std::unique_ptr<ControllerModel> model_ = make_controller_model(settings_);
    SimulatedClock clock_;
    SimulatedBus bus_{*model_, clock_};
    P panel_ = make_panel<P>(bus_, settings_);
    std::size_t frames_wanted_;
    std::vector<std::string> passed_;
    std::vector<ShownFrame> frames_;
    std::optional<Error> error_;
};

/// What a board with such a panel shows: the firmware sends to the simulator what differs from the picture
/// before, and the pictures are decoded from the bytes on its bus. show() throws Failure for a mistake there.
///
/// `scene` is a checked scene and must outlive the source.
std::unique_ptr<FrameSource> open_board_source(std::span<const std::byte> scene,
                                               const PanelSettings& settings);

}
