#pragma once

#include "core/bytes/result.hpp"
#include "core/playhead.hpp"
#include "core/pose/scene_state.hpp"
#include "core/scene/scene_view.hpp"
#include "firmware/chip/microseconds.hpp"
#include "firmware/link/device.hpp"
#include "firmware/link/input_message.hpp"
#include "firmware/link/laser_interlock.hpp"
#include "firmware/link/message.hpp"
#include "firmware/link/restart_counter.hpp"
#include "firmware/link/scene_memory.hpp"
#include "firmware/run/board.hpp"
#include "firmware/run/controls.hpp"
#include "firmware/run/placed_input.hpp"
#include "firmware/settings/board_settings.hpp"
#include "firmware/status.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace kfast::link {

struct BoardFacts;

/// The bytes of the block that a player for a panel of that size needs.
std::size_t panel_player_bytes(const SceneView& scene, const BoardFacts& facts);
/// The bytes that a player for the beam of the settings needs.
std::size_t beam_player_bytes(const SceneView& scene, const BoardFacts& facts);

/// The facts of a board for its stage. What is referred to outlives it.
struct BoardFacts {
    const BoardSettings& settings;
    StoredText<24> serial{}; ///< unique to the chip
    StoredText<24> board{};  ///< its name
    StoredText<24> panel{};  ///< its name
    Size panel_size{};       ///< empty: there is no display that works; for a beam its resolution, twice
    std::size_t (*player_bytes)(const SceneView&, const BoardFacts&) = panel_player_bytes;
    std::span<std::byte> block{};          ///< lent to the player, aligned to 4
    std::span<const std::byte> built_in{}; ///< where a scene may be, perhaps with more bytes after it
    bool is_dimmable = false;              ///< the display has a brightness
    bool has_boot_loader = false;
    /// Lets a dangerous beam shine, or not. Null: there is none (LaserInterlock).
    void (*set_armed)(bool is_armed) = nullptr;
    Restarts restarts{}; ///< before this start
    /// Keeps a word over the next restart by the watchdog. Null: there is none (RestartCounter).
    void (*keep)(std::uint32_t word) = nullptr;
};

/// What plays on a board, and what shall play next, as its computer (Link), its buttons and its knobs set
/// it: what a device is that is the same on every board. The board calls it between frames, and run_scenes()
/// lets what plays change there and nowhere else.
///
/// A scene in RAM is in what the scene that plays does not need of the player's block (SceneMemory). If that
/// needs too much, it gives way: the picture stays until the new scene plays. At most half of the block is
/// lent.
class PlaybackSession {
public:
    /// At first the built-in scene plays, whatever it is; nothing if safe mode does not allow it (Restarts).
    explicit PlaybackSession(const BoardFacts& facts);

    // What Link requires of its device (device.hpp).
    DeviceFacts facts() const;
    Playing playing() const;
    Statistics statistics() const
    {
        return {.frames = frames_, .late = late_, .skipped = skipped_, .coarse = coarse_};
    }
    InputState input(std::uint8_t number) const;
    std::span<const std::byte> played() const;
    std::span<const std::byte> built_in() const { return facts_.built_in; }
    Status play(const SceneSelection& selection, const SceneView& scene);
    void play_nothing();
    std::span<std::byte> lease_ram(std::uint32_t size);
    std::span<std::byte> leased_ram() const { return memory_.leased(); }
    void end_lease();
    bool is_idle() const { return now_.holds && memory_.leased().empty() && !is_changing() && !gave_way_; }
    void pause();
    void resume();
    void seek(Time time);
    void set_speed(std::int32_t speed);
    Status arm() { return interlock_.arm(); }
    Status disarm() { return interlock_.disarm(); }
    void lose_computer() { interlock_.lose_computer(); }
    Status set_brightness(std::uint8_t brightness);
    void set_input(std::uint32_t number, Time place);
    Status set_text(std::uint32_t number, std::string_view text);
    Status deliver(const DrawingPart& part);
    Status enter_boot_loader(Microseconds now);

    /// Whether something else shall play as soon as the frame has come to its end. Until then no reports must
    /// be taken.
    bool is_changing() const { return next_.has_value(); }
    /// Whether begin() must be called, between frames.
    bool wants_to_begin() const { return is_changing() || is_new_; }
    /// Begins what shall play. Returns false if nothing is to be drawn: the picture stays.
    bool begin();

    // What the run loop requires of a board (firmware/run/board.hpp), after begin().
    std::span<const std::byte> scene_bytes() const { return now_.selection.scene; }
    std::span<std::byte> block() const { return memory_.before(now_.selection.scene); }
    void scene_started(const SceneView& scene);
    /// Null when it is over.
    void plays(SceneState* player) { player_ = player; }
    Playhead playhead() const { return controls_->playhead(); }
    template <TouchedPins Pins>
    void steer(Playhead& playhead, Pins& pins, Microseconds now)
    {
        restarts_.pass(now);
        controls_->steer(playhead, pins, now);
        steered(playhead);
    }
    /// Called between two calls of steer(), and when nothing plays any more.
    template <TouchedPins Pins>
    void watch_arming(Pins& pins, Microseconds now)
    {
        if (!controls_)
            return;
        controls_->watch_arming(pins, now);
        obey_arming();
    }
    std::span<const PlacedInput> inputs() const { return controls_->inputs(); }
    bool wants_rest() const { return controls_->wants_rest(); }
    void frame_shown(const FrameReport& report);
    void fault();

    /// The brightness of the display, as computer, knobs and settings have it.
    std::uint8_t brightness() const { return brightness_; }
    /// Whether it is time to leave for the boot loader.
    bool is_to_leave(Microseconds now) const { return leaves_ && reached(now, *leaves_); }

private:
    struct PlaybackItem {
        SceneSelection selection;
        std::optional<SceneView>
            scene;          ///< of the selection; none if it is not known yet, or cannot be played
        bool holds = false; ///< whether nothing is selected, and the picture stays
    };

    bool has_display() const { return facts_.panel_size.width > 0 && facts_.panel_size.height > 0; }
    std::size_t player_bytes(const SceneView& scene) const { return facts_.player_bytes(scene, facts_); }
    std::span<std::byte> lease(std::uint32_t size);
    void give_way();
    PlaybackItem built_in_item() const;
    void change(const PlaybackItem& item);
    void set_current(const PlaybackItem& item);
    [[gnu::cold, gnu::noinline]] void set_up_controls();
    void steered(const Playhead& playhead);
    void obey_arming();
    Time place_of(std::uint32_t number, const InputView& input) const;

    BoardFacts facts_;
    SceneMemory memory_;
    LaserInterlock interlock_;
    RestartCounter restarts_;
    PlaybackItem now_;
    bool is_new_ = true;                   ///< what plays now has not begun
    bool is_drawn_ = false;                ///< frames of it are under way
    std::optional<PlaybackItem> next_;     ///< if what plays now is drawn
    std::optional<PlaybackItem> gave_way_; ///< plays again if no scene comes for which it gave way
    std::optional<Controls> controls_;     ///< of what plays now, or played last
    SceneState* player_ = nullptr;         ///< of what plays now, as long as it draws
    Time moment_{};
    std::uint8_t brightness_;
    std::uint8_t turned_brightness_; ///< as the controls had it last
    std::uint32_t frames_ = 0;
    std::uint32_t late_ = 0;
    std::uint32_t coarse_ = 0;
    std::uint32_t skipped_ = 0;
    std::uint32_t skipped_of_scene_ = 0;
    std::optional<Microseconds> leaves_;
};

static_assert(Device<PlaybackSession>);

}
