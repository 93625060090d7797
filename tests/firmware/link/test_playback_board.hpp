#pragma once

#include "firmware/link/link_service.hpp"
#include "firmware/link/playback_session.hpp"
#include "firmware/link/restart_notice.hpp"
#include "firmware/run/panel_mirror.hpp"
#include "firmware/run/run.hpp"
#include "host/player/received_drawing.hpp"
#include "host/text/characters.hpp"
#include "tests/firmware/link/pretend_pipe.hpp"
#include "tests/firmware/link/taking_turns.hpp"
#include "tests/firmware/run/pretend_pins.hpp"
#include "tests/firmware/slots/slot_bench.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace kfast::test {

inline constexpr Size small_panel{.width = 64, .height = 48};

/// A display whose picture can be looked at.
class MirroredPanel {
public:
    static constexpr PixelFormat format = PixelFormat::rgb565;
    static constexpr Size granularity{.width = 1, .height = 1};
    static constexpr int window_bytes = 11;

    Size size() const { return small_panel; }
    template <class Pause>
    void begin(Pause&& pause)
    {
        ++beginnings;
        pause(Microseconds{120'000});
    }
    void start(Rect area, std::span<const std::byte> pixels) { mirror_.take(area, pixels); }
    bool busy() const { return false; }
    void set_brightness(std::uint8_t) {}
    template <class Pause>
    void sleep(Pause&&)
    {
    }
    template <class Pause>
    void wake(Pause&&)
    {
    }

    std::span<const std::byte> picture() const { return mirror_.bytes(); }

    int beginnings = 0;

private:
    PanelMirror<format, small_panel.width, small_panel.height> mirror_;
};

/// A board with a stage, and a computer that has its turn whenever the board listens: everything is called in
/// the order in which a chip does it. Checks each frame against what the scene says, drawn apart from it.
class TestPlaybackBoard {
public:
    explicit TestPlaybackBoard(const BoardSettings& with = {}, std::size_t block_bytes = 40'000)
        : settings{with}, block_(block_bytes / 4)
    {
        built_in = padded_scene(2000, 0);
    }

    /// Lets time pass.
    void run_for(std::uint32_t milliseconds)
    {
        end_ = now_ + Microseconds{1000 * milliseconds};
        if (!playback_)
            start();
        life_.step();
    }

    link::PlaybackSession& playback() { return *playback_; }

    // As ChangingBoard has it.
    MirroredPanel& panel() { return panel_; }
    Microseconds now() const { return now_; }
    void sleep_until(Microseconds moment)
    {
        do
            tick();
        while (!reached(now_, moment));
    }
    void linger_until(Microseconds moment)
    {
        while (running() && !reached(now_, moment))
            tick();
    }
    void listen() { tick(); }
    bool wants_to_run() const { return true; }
    bool running() const { return !playback_->wants_to_begin(); }
    bool begin()
    {
        is_drawing = playback_->begin();
        return is_drawing;
    }
    std::span<const std::byte> scene_bytes() const { return playback_->scene_bytes(); }
    std::span<std::byte> block() const { return playback_->block(); }
    std::array<std::span<std::byte>, 2> bands() { return {bands_[0], bands_[1]}; }
    void scene_started(const SceneView& scene)
    {
        playback_->scene_started(scene);
        const auto bytes = playback_->scene_bytes();
        shown_.assign(bytes.begin(), bytes.end());
        ++scenes_begun;
        begun_at = now_;
    }
    void plays(SceneState* player)
    {
        player_ = player;
        playback_->plays(player);
    }
    Playhead playhead(const SceneView&) const { return playback_->playhead(); }
    void steer(Playhead& playhead) { playback_->steer(playhead, pins, now_); }
    std::span<const PlacedInput> inputs()
    {
        const auto placed = playback_->inputs();
        placed_.assign(placed.begin(), placed.end());
        keep_inputs();
        return placed_;
    }
    bool wants_rest() const { return playback_->wants_rest(); }
    void frame_shown(const FrameReport& report)
    {
        playback_->frame_shown(report);
        CHECK(std::ranges::equal(panel_.picture(), picture_at(report.time)));
        frames.push_back(report);
    }
    void fault(Error error)
    {
        playback_->fault();
        faults.push_back(error);
        is_drawing = false;
    }
    BoardNames names() const { return {"a board", "a panel"}; }
    Notice notice()
    {
        notice_ = link::RestartNotice{restarts};
        return notice_.notice();
    }
    void notice_shown() { ++notices; }

    const Scene& scene_begun() const { return shown_; }
    /// That the last frame showed.
    const ReceivedDrawing& drawing(std::uint32_t input) const { return drawings_.at(input); }

    BoardSettings settings;
    link::Restarts restarts;
    /// What the board has kept for the time after a restart; of the board that was used last.
    static inline std::uint32_t kept = 0;
    Scene built_in;
    PretendFlash flash{small_flash_bytes};
    Store slots{flash, small_places};
    PretendPipe pipe;
    PretendPins pins;
    /// What the computer does in each millisecond.
    std::function<void()> computer = [] {};
    Microseconds flash_time{}; ///< that every operation takes
    std::vector<FrameReport> frames;
    std::vector<Error> faults;
    int scenes_begun = 0;
    int notices = 0;
    Microseconds begun_at{};
    bool is_drawing = false;

private:
    using LinkService = link::LinkService<PretendPipe, PretendFlash>;

    void start()
    {
        playback_.emplace(link::BoardFacts{.settings = settings,
                                           .serial = {"E6"},
                                           .board = {"board"},
                                           .panel = {"panel"},
                                           .panel_size = small_panel,
                                           .block = std::as_writable_bytes(std::span{block_}),
                                           .built_in = built_in,
                                           .is_dimmable = true,
                                           .has_boot_loader = true,
                                           .restarts = restarts,
                                           .keep = [](std::uint32_t word) { kept = word; }});
        link_service_.emplace(pipe, *playback_, slots);
        link_service_->begin();
    }

    void tick()
    {
        now_ = now_ + Microseconds{1000};
        computer();
        const auto before = flash.operations();
        link_service_->serve([this, before] {
            return now_ +
                   Microseconds{flash_time.count * static_cast<std::uint32_t>(flash.operations() - before)};
        });
        now_ =
            now_ + Microseconds{flash_time.count * static_cast<std::uint32_t>(flash.operations() - before)};
        if (is_drawing && playback_->scene_bytes().size() == shown_.size())
            CHECK(std::ranges::equal(playback_->scene_bytes(), shown_));
        if (reached(now_, end_))
            life_.pause();
    }

    /// What is shown in the next frame.
    void keep_inputs()
    {
        drawings_.clear();
        texts_.clear();
        for (std::uint32_t input = 0; input < player_->scene().input_count(); ++input) {
            const InputView view = player_->scene().input(input);
            if (view.type == InputType::drawing)
                drawings_[input] = received_drawing(player_->drawing(input));
            else if (view.type == InputType::text)
                for (const std::byte glyph : player_->text(input))
                    append_utf8(texts_[input],
                                view.text.glyphs.character(std::to_integer<std::uint32_t>(glyph)));
        }
    }

    /// Drawn from a copy of the scene as it was when it began.
    std::vector<std::byte> picture_at(Time time)
    {
        const auto scene = SceneView::parse(shown_);
        REQUIRE(scene);
        std::vector<std::uint32_t> block(Player::block_bytes(*scene, small_panel) / 4 + 1);
        auto player =
            Player::create(*scene, small_panel, Fit::contain, std::as_writable_bytes(std::span{block}));
        REQUIRE(player);
        for (const auto& [number, place] : placed_)
            player->set_input(number, place);
        for (const auto& [number, drawing] : drawings_)
            REQUIRE(player->set_drawing(number, strokes_of(drawing)));
        for (const auto& [number, text] : texts_)
            player->set_text(number, text);
        player->show_moment(time);
        std::vector<std::byte> pixels(small_panel.width * small_panel.height * 2);
        player->draw_rows<PixelFormat::rgb565>(small_panel.height, pixels);
        return pixels;
    }

    link::RestartNotice notice_{{}};
    MirroredPanel panel_;
    std::vector<std::uint32_t> block_;
    std::array<std::vector<std::byte>, 2> bands_{std::vector<std::byte>(8 * 128),
                                                 std::vector<std::byte>(8 * 128)};
    Microseconds now_{0xFFF0'0000}; // the clock wraps soon
    Microseconds end_{};
    std::optional<link::PlaybackSession> playback_;
    std::optional<LinkService> link_service_;
    Scene shown_;
    std::vector<PlacedInput> placed_;
    std::map<std::uint32_t, ReceivedDrawing> drawings_;
    SceneState* player_ = nullptr;
    std::map<std::uint32_t, std::string> texts_;
    TakingTurns life_{[this] { run_scenes(*this); }};
};

static_assert(ChangingBoard<TestPlaybackBoard>);
static_assert(InputBoard<TestPlaybackBoard>);
static_assert(RestingBoard<TestPlaybackBoard>);
static_assert(ListeningBoard<TestPlaybackBoard>);
static_assert(LiveInputBoard<TestPlaybackBoard>);
static_assert(NoticingBoard<TestPlaybackBoard>);

}
