#pragma once

#include "core/bytes/result.hpp"
#include "firmware/link/link_service.hpp"
#include "firmware/link/playback_session.hpp"
#include "firmware/panel/panel_choice.hpp"
#include "firmware/run/run.hpp"
#include "firmware/settings/board_settings.hpp"
#include "firmware/settings/rp2040_flash.hpp"
#include "firmware/slots/slot_store.hpp"
#include "host/program/failure.hpp"
#include "host/simulator/flash_file.hpp"
#include "host/simulator/onlooker.hpp"
#include "host/simulator/report_socket.hpp"
#include "host/simulator/simulated_bus.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace kfast {

/// What a simulated board with a plug is made of besides its display.
struct PluggedParts {
    const BoardSettings& settings;
    StoredText<24> serial;
    std::span<const std::byte> built_in; ///< a scene, or nothing
    FlashFile& flash;                    ///< with the slots where a Pico has them
    ReportSocket& plug;
    Onlooker& onlooker;
};

/// A board that exists in memory and runs in real time, with a plug that programs talk to: the firmware's
/// loop, link and slots, and its driver `P` against a model of the controller. It lends at least as much
/// memory as a Pico does, and has no controls.
template <Panel P>
class PluggedBoard {
public:
    /// All parts must outlive the board. `P` drives the controller that the settings name.
    explicit PluggedBoard(const PluggedParts& parts) : parts_{parts}
    {
        for (auto& band : bands_)
            band.resize(band_rows * row_bytes(P::format, panel_.size().width));
        model_->reset(clock_.elapsed());
        link_service_.begin();
    }
    PluggedBoard(const PluggedBoard&) = delete;

    BoardNames names() const { return {board_name, controller_name(parts_.settings.panel.controller)}; }
    P& panel() { return panel_; }
    Microseconds now()
    {
        const auto since_start = std::chrono::steady_clock::now() - start_;
        const auto microseconds = std::chrono::duration_cast<std::chrono::microseconds>(since_start);
        const Microseconds real{static_cast<std::uint32_t>(microseconds.count())};
        clock_.pass(real - clock_.now());
        return real;
    }

    bool wants_to_run() { return !parts_.onlooker.has_seen_enough(); }
    bool running() { return wants_to_run() && !playback_.wants_to_begin(); }
    bool begin() { return playback_.begin(); }

    void listen()
    {
        link_service_.serve([this] { return now(); });
    }
    void sleep_until(Microseconds moment)
    {
        doze_until(moment, [] { return true; });
    }
    void linger_until(Microseconds moment)
    {
        doze_until(moment, [this] { return running(); });
    }

    std::span<const std::byte> scene_bytes() { return playback_.scene_bytes(); }
    std::span<std::byte> block() { return playback_.block(); }
    std::array<std::span<std::byte>, 2> bands() { return {bands_[0], bands_[1]}; }

    void scene_started(const SceneView& scene) { playback_.scene_started(scene); }
    void plays(SceneState* player) { playback_.plays(player); }
    Playhead playhead(const SceneView&) { return playback_.playhead(); }
    void steer(Playhead& playhead)
    {
        playback_.steer(playhead, pins_, now());
        if (const std::uint8_t wanted = playback_.brightness(); wanted != brightness_)
            panel_.set_brightness(brightness_ = wanted);
    }
    std::span<const PlacedInput> inputs() const { return playback_.inputs(); }

    void event_passed(const EventView& event) { parts_.onlooker.hear(event); }
    void frame_shown(const FrameReport& report)
    {
        playback_.frame_shown(report);
        parts_.onlooker.see(picture(), report.time, playback_.playing());
    }
    void fault(Error error)
    {
        const bool is_blank = playback_.scene_bytes().empty();
        playback_.fault();
        parts_.onlooker.see_nothing(picture(), is_blank ? "no scene" : error_text(error));
    }

private:
    static constexpr std::size_t player_block_bytes = 88 * 1024;
    static constexpr int band_rows = 24;
    static constexpr std::string_view board_name = "Simulator";

    /// Pins that are not there never change.
    struct NoPins {
        bool pressed(Pin) const { return false; }
        int level(Pin) const { return 0; }
    };

    link::BoardFacts facts()
    {
        return {.settings = parts_.settings,
                .serial = parts_.serial,
                .board = {board_name},
                .panel = {controller_name(parts_.settings.panel.controller)},
                .panel_size = panel_.size(),
                .block = block_,
                .built_in = parts_.built_in,
                .is_dimmable = PoweredPanel<P>};
    }

    /// Upright.
    Frame picture() const
    {
        if (const auto mistake = bus_.error() ? bus_.error() : model_->error())
            throw Failure("the simulated panel was driven wrongly: " + *mistake);
        return seen_upright(model_->picture(), parts_.settings.panel.rotation);
    }

    template <class GoesOn>
    void doze_until(Microseconds moment, GoesOn&& goes_on)
    {
        constexpr Microseconds nap{10'000}; // the onlooker may have seen enough
        listen();
        while (goes_on() && wants_to_run() && !reached(now(), moment)) {
            const std::uint32_t rest = std::min((moment - now()).count, nap.count);
            parts_.plug.wait(std::chrono::microseconds{rest});
            listen();
        }
    }

    PluggedParts parts_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    SimulatedClock clock_; ///< follows the real one
    std::unique_ptr<ControllerModel> model_ = make_controller_model(parts_.settings.panel);
    SimulatedBus bus_{*model_, clock_};
    P panel_ = make_panel<P>(bus_, parts_.settings.panel);
    std::vector<std::byte> block_ = std::vector<std::byte>(player_block_bytes);
    std::array<std::vector<std::byte>, 2> bands_;
    NoPins pins_;
    std::uint8_t brightness_ = parts_.settings.panel.brightness;
    link::PlaybackSession playback_{facts()};
    SlotStore<FlashFile> slots_{parts_.flash, rp2040::slot_places};
    link::LinkService<ReportSocket, FlashFile> link_service_{parts_.plug, playback_, slots_};
};

/// Runs a simulated board until its onlooker has seen enough. Throws Failure for what the firmware does wrong
/// on the wires of the display.
void run_plugged_board(const PluggedParts& parts);

}
