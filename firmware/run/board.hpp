#pragma once

#include "core/bytes/result.hpp"
#include "core/playhead.hpp"
#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"
#include "firmware/chip/microseconds.hpp"
#include "firmware/panel/panel.hpp"
#include "firmware/run/beam.hpp"
#include "firmware/run/placed_input.hpp"

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>

namespace kfast {

class SceneState;

/// What the run loop reports to a board about a frame.
struct FrameReport {
    Time time;
    std::uint32_t skipped = 0; ///< frames left out since the scene began, because their time had passed
    bool is_late = false;      ///< it had not arrived when the next one was due
    bool is_coarse = false;    ///< for want of room its curves are coarser, or parts of it are missing
};

/// What a board prints on its test card, in the letters of small_font.hpp.
struct BoardNames {
    std::string_view board;
    std::string_view panel;
};

/// What a board shows before it plays: a title and words in the letters of small_font.hpp. No title: nothing.
struct Notice {
    std::string_view title;
    std::string_view words;
};

// Compound requirements would be torn apart.
// clang-format off

/// What the run loop requires of every board.
template <class B>
concept Board = requires(B& board, Microseconds moment, const SceneView& scene, FrameReport report, Error error) {
    { board.now() } -> std::same_as<Microseconds>;
    /// Returns at once when `moment` is past.
    { board.sleep_until(moment) } -> std::same_as<void>;

    /// The scene to play, perhaps with more bytes after it.
    { board.scene_bytes() } -> std::same_as<std::span<const std::byte>>;
    /// Memory lent to the player, aligned to 4.
    { board.block() } -> std::same_as<std::span<std::byte>>;
    /// The loop ends when this is false.
    { board.running() } -> std::same_as<bool>;
    /// `scene` was accepted and begins.
    { board.scene_started(scene) } -> std::same_as<void>;
    /// The whole picture has arrived in the panel, or the beam draws it as soon as the one before has ended.
    { board.frame_shown(report) } -> std::same_as<void>;
    /// No scene plays, and why. A panel shows the number of the error; a beam is dark.
    { board.fault(error) } -> std::same_as<void>;
};

/// A board with a panel. boards/template/ is the list to fill in.
template <class B>
concept PanelBoard = Board<B> && requires(B& board) {
    requires Panel<std::remove_reference_t<decltype(board.panel())>>;
    /// Two buffers of equal size, aligned to 4: one is drawn while the other is sent. Each holds at
    /// least as many rows as the panel takes at once.
    { board.bands() } -> std::same_as<std::array<std::span<std::byte>, 2>>;
};

/// A board with a vector display.
template <class B>
concept BeamBoard = Board<B> && requires(B& board) {
    requires Beam<std::remove_reference_t<decltype(board.beam())>>;
};

/// A board that plays only what its scenes need (core/features.hpp), so that the rest is not linked. Boards that
/// a computer sends scenes to have all features: what it sends is not known before.
template <class B>
concept FeatureBoard = Board<B> && requires(B& board) {
    { board.features() } -> std::same_as<const Features&>;
};

/// A board that wants to see what goes to the panel: every area and its pixels, packed row by row.
template <class B>
concept WatchingBoard = PanelBoard<B> && requires(B& board, Rect area, std::span<const std::byte> pixels) {
    { board.watch(area, pixels) } -> std::same_as<void>;
};

/// A board whose panel may have lost what it showed. Asked once before every frame, which is sent
/// whole if it does.
template <class B>
concept RedrawingBoard = PanelBoard<B> && requires(B& board) {
    { board.wants_redraw() } -> std::same_as<bool>;
};

/// A board that is notified of the events of the scene as they are passed, each before its frame is drawn. It
/// may copy the view: the name is in the scene.
template <class B>
concept EventBoard = Board<B> && requires(B& board, const EventView& event) {
    { board.event_passed(event) } -> std::same_as<void>;
};

/// A board that chooses what is played: a clip, from where, and how fast. Called after scene_started().
template <class B>
concept ChoosingBoard = Board<B> && requires(B& board, const SceneView& scene) {
    { board.playhead(scene) } -> std::same_as<Playhead>;
};

/// A board with controls. Called once before every frame, whatever is played.
template <class B>
concept SteeredBoard = Board<B> && requires(B& board, Playhead& playhead) {
    { board.steer(playhead) } -> std::same_as<void>;
};

/// A board that sets inputs of the scene. Called once before every frame, after steer(). An input that
/// is not in the answer stays as it was. The answer need not stay valid any longer.
template <class B>
concept InputBoard = Board<B> && requires(B& board) {
    { board.inputs() } -> std::convertible_to<std::span<const PlacedInput>>;
};

/// A board that sets drawings and texts of the scene while it plays. It has the player from the time at which
/// it is ready until it is over: then it is null.
template <class B>
concept LiveInputBoard = Board<B> && requires(B& board, SceneState* player) {
    { board.plays(player) } -> std::same_as<void>;
};

template <class B>
concept PoweredPanelBoard = PanelBoard<B> && PoweredPanel<std::remove_reference_t<decltype(std::declval<B&>().panel())>>;

/// A board that can switch its display off: while it wants to rest, time stands still and nothing is shown.
template <class B>
concept RestingBoard = SteeredBoard<B> && (PoweredPanelBoard<B> || BeamBoard<B>) && requires(B& board) {
    { board.wants_rest() } -> std::same_as<bool>;
};

/// A board that knows when its display has shown a picture. Called once for every frame that changes
/// anything, with its first band drawn; returns when sending may begin.
template <class B>
concept SynchronizedBoard = PanelBoard<B> && requires(B& board) {
    { board.wait_for_blank() } -> std::same_as<void>;
};

/// A board that receives messages while it draws. Called before each part of a picture, and whenever it
/// sleeps it checks by itself. A message that changes what is played waits for the end of the frame.
template <class B>
concept ListeningBoard = Board<B> && requires(B& board) {
    { board.listen() } -> std::same_as<void>;
};

/// A board on which what plays may change: one scene is run after another, and the display begun once (run_scenes()).
template <class B>
concept ChangingBoard = Board<B> && requires(B& board, Microseconds moment) {
    /// Called before running(). Returns false if there is nothing to draw: a panel shows what it shows, a
    /// beam is dark.
    { board.begin() } -> std::same_as<bool>;
    /// As sleep_until(), but returns as soon as running() is false.
    { board.linger_until(moment) } -> std::same_as<void>;
    /// All ends when this is false, and so is running().
    { board.wants_to_run() } -> std::same_as<bool>;
};

/// A board that may have something to say to whoever looks at its panel before anything plays, and as long as there is
/// nothing to play.
template <class B>
concept NoticingBoard = PanelBoard<B> && requires(B& board) {
    /// Its texts stay valid.
    { board.notice() } -> std::same_as<Notice>;
    /// The notice has arrived in the panel.
    { board.notice_shown() } -> std::same_as<void>;
};

/// A board whose panel shows a test card when it has no scene: when the first four bytes of its place are all
/// 0xFF, as erased flash is, or all 0.
template <class B>
concept NamedBoard = PanelBoard<B> && requires(const B& board) {
    { board.names() } -> std::same_as<BoardNames>;
};

// clang-format on

/// What a board can play.
template <Board B>
const Features& features_of(B& board)
{
    static_assert(!(FeatureBoard<B> && ChangingBoard<B>));
    if constexpr (requires { board.features(); }) {
        static_assert(FeatureBoard<B>, "features() returns const Features&");
        return board.features();
    } else if constexpr (BeamBoard<B>) {
        return every_feature_but_outlines;
    } else {
        return every_feature;
    }
}

}
