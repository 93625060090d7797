#pragma once

#include "core/bytes/result.hpp"
#include "firmware/run/board.hpp"
#include "firmware/run/panel_mirror.hpp"
#include "firmware/serial/console.hpp"
#include "firmware/version.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <utility>

namespace kfast {

// Compound requirements would be torn apart.
// clang-format off

/// The time since begin().
template <class T>
concept BoardClock = requires(T& clock, const T& running, Microseconds moment) {
    { clock.begin() } -> std::same_as<void>;
    { running.now() } -> std::same_as<Microseconds>;
    /// Returns at once when `moment` is past.
    { running.sleep_until(moment) } -> std::same_as<void>;
};

// clang-format on

/// The common part of all boards that are watched and controlled through a console: for tests.
/// It reports, one line each:
///
///     KFAST <version> <board> <panel> <size> <format>
///     SCENE <bytes> <CRC-32>
///     EVENT <name>                                                    when it is passed, before the frame
///     F <time in 1/1024 frame> <CRC-32 of the picture> <bytes sent>   when it has arrived
///     ERROR <name>: <meaning>                                         instead of SCENE
///
/// and listens. `s` starts the scene again, stepped, and is answered with STEP: from then on a frame stays,
/// and the time with it, until a byte comes, whatever it is. In either mode `r` has the next frame sent
/// whole, and `q` ends and is answered with END.
///
/// The picture is what the panel shows, of size `glass`, assembled from what was sent to it; the bytes
/// include the commands of windows. What remains to a board is panel(), block(), bands(), scene_bytes()
/// and scene_started(), which calls report_scene().
template <Console C, BoardClock T, Panel P, Size glass>
class ConsoleBoard {
public:
    /// Whether there is something to run, for the first time or again.
    bool wants_to_run() const { return mode_ != Mode::ended; }

    Microseconds now() const { return mode_ == Mode::stepped ? stepped_clock_ : clock_.now(); }

    void sleep_until(Microseconds moment)
    {
        if (mode_ != Mode::stepped)
            return clock_.sleep_until(moment);
        if (frame_stands_)
            obey(console_.read());
        frame_stands_ = false;
        stepped_clock_ = moment;
    }

    bool running()
    {
        if (mode_ != Mode::free_running || !console_.pending())
            return mode_ != Mode::ended;
        const char wish = console_.read();
        obey(wish);
        if (wish != 's')
            return mode_ != Mode::ended;
        mode_ = Mode::stepped;
        write_text(console_, "STEP\n");
        return false; // to be run again from the first frame
    }

    void watch(Rect area, std::span<const std::byte> pixels)
    {
        mirror_.take(area, pixels);
        bytes_sent_ += static_cast<std::uint32_t>(pixels.size()) + P::window_bytes;
    }

    bool wants_redraw() { return std::exchange(wants_redraw_, false); }

    void event_passed(const EventView& event) { write_line("EVENT ", event.name); }

    void frame_shown(FrameReport report)
    {
        write_text(console_, "F ");
        write_decimal(console_, static_cast<std::uint32_t>(report.time.ticks));
        console_.write(' ');
        write_hex(console_, mirror_.hash());
        console_.write(' ');
        write_decimal(console_, std::exchange(bytes_sent_, 0));
        console_.write('\n');
        frame_stands_ = mode_ == Mode::stepped;
    }

    void fault(Error error)
    {
        write_line("ERROR ", error_text(error));
        mode_ = Mode::ended;
    }

protected:
    /// `console` must outlive the board.
    explicit ConsoleBoard(C& console) : console_{console} {}

    /// Starts the clock and introduces the board: its name, panel, size and format.
    void begin(std::string_view name)
    {
        clock_.begin();
        write_text(console_, "KFAST ");
        write_text(console_, version);
        write_line(" ", name);
    }

    /// `bytes` are those of the scene and no others.
    void report_scene(std::span<const std::byte> bytes) { write_scene_line(console_, bytes); }

private:
    enum class Mode { free_running, stepped, ended };

    void write_line(std::string_view what, std::string_view text)
    {
        write_text(console_, what);
        write_text(console_, text);
        console_.write('\n');
    }

    void obey(char wish)
    {
        if (wish == 'q')
            end();
        if (wish == 'r')
            wants_redraw_ = true;
    }

    void end()
    {
        write_text(console_, "END\n");
        mode_ = Mode::ended;
    }

    static inline PanelMirror<P::format, glass.width, glass.height> mirror_; ///< too large for a stack

    C& console_;
    T clock_;
    std::uint32_t bytes_sent_ = 0; ///< since the last report
    bool wants_redraw_ = false;
    Mode mode_ = Mode::free_running;
    bool frame_stands_ = false; ///< whether, when stepped, it is shown and not yet answered
    Microseconds stepped_clock_;
};

}
