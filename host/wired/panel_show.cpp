#include "host/wired/panel_show.hpp"

#include "firmware/chip/microseconds.hpp"
#include "firmware/panel/bus.hpp"
#include "firmware/panel/panel_choice.hpp"
#include "firmware/panel/panel_reset.hpp"
#include "firmware/run/run.hpp"
#include "host/program/failure.hpp"
#include "host/program/interruption.hpp"
#include "host/wired/panel_lines.hpp"
#include "host/wired/spi_device.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <span>
#include <utility>
#include <vector>

namespace kfast {

namespace {

/// A display on an 8080 bus of eight bits, made of GPIO lines: two calls of the kernel for each byte. The
/// data is taken when WR rises. The display's RD is to be wired high. Everything has been sent when a call
/// returns.
class ParallelBus {
public:
    /// `lines`, which have D/C, WR and all of the data, must outlive the bus.
    explicit ParallelBus(PanelLines& lines) : lines_{lines} {}

    void command(std::span<const std::byte> bytes) { send(bytes, 0); }
    void parameters(std::span<const std::byte> bytes) { send(bytes, line_bit(LineRole::dc)); }
    void start_data(std::span<const std::byte> bytes) { parameters(bytes); }
    bool busy() const { return false; }

private:
    static_assert(line_bit(LineRole::data0) == 1 && line_bit(LineRole::data7) == 0x80, "as in a byte");

    void send(std::span<const std::byte> bytes, std::uint32_t dc)
    {
        constexpr std::uint32_t write = line_bit(LineRole::write);
        constexpr std::uint32_t all = 0xFF | write | line_bit(LineRole::dc) | line_bit(LineRole::select);
        for (const std::byte byte : bytes) {
            lines_.set(all, std::to_integer<std::uint32_t>(byte) | dc);
            lines_.set(write, write);
        }
        lines_.set(LineRole::select, true);
    }

    PanelLines& lines_;
};

static_assert(DisplayBus<ParallelBus>);

/// A display on spidev; D/C is a GPIO line, and so is chip select if it is among the lines. Everything has
/// been sent when a call returns.
class SpidevBus {
public:
    /// `spi` and `lines`, which have D/C, must outlive the bus.
    SpidevBus(SpiDevice& spi, PanelLines& lines) : spi_{spi}, lines_{lines} {}

    void command(std::span<const std::byte> bytes) { send(bytes, 0); }
    void parameters(std::span<const std::byte> bytes) { send(bytes, line_bit(LineRole::dc)); }
    void start_data(std::span<const std::byte> bytes) { parameters(bytes); }
    bool busy() const { return false; }

private:
    void send(std::span<const std::byte> bytes, std::uint32_t dc)
    {
        lines_.set(line_bit(LineRole::dc) | line_bit(LineRole::select), dc);
        spi_.write(bytes);
        lines_.set(LineRole::select, true);
    }

    SpiDevice& spi_;
    PanelLines& lines_;
};

static_assert(DisplayBus<SpidevBus>);

/// The clock of a computer, for a board that sleeps between pictures. When half an hour has passed since it
/// was last read the program was stopped (Ctrl-Z), which does not count: the run loop could not distinguish
/// that from a frame that is not due yet.
class SteadyClock {
public:
    Microseconds now();
    /// Waits for all of that time.
    void pause(Microseconds time) const;
    /// Waits until `moment`, or until a signal arrives that RememberedInterruption remembers.
    void sleep_until(Microseconds moment);

private:
    std::int64_t asked_ = 0;   ///< nanoseconds of the computer
    std::int64_t stopped_ = 0; ///< how many of them do not count
};

constexpr std::int64_t nanoseconds_per_second = 1'000'000'000;
constexpr std::int64_t nanoseconds_per_microsecond = 1'000;

std::int64_t nanoseconds_now()
{
    timespec time{};
    ::clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec * nanoseconds_per_second + time.tv_nsec;
}

/// Returns false if a signal came before.
bool sleep_until(std::int64_t nanoseconds)
{
    const timespec moment{.tv_sec = nanoseconds / nanoseconds_per_second,
                          .tv_nsec = nanoseconds % nanoseconds_per_second};
    return ::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &moment, nullptr) == 0;
}

Microseconds in_microseconds(std::int64_t nanoseconds)
{
    return {static_cast<std::uint32_t>(nanoseconds / nanoseconds_per_microsecond)};
}

Microseconds SteadyClock::now()
{
    constexpr std::int64_t longest = 30 * 60 * nanoseconds_per_second;
    const std::int64_t before = std::exchange(asked_, nanoseconds_now());
    if (before != 0 && asked_ - before > longest)
        stopped_ += asked_ - before;
    return in_microseconds(asked_ - stopped_);
}

void SteadyClock::pause(Microseconds time) const
{
    const std::int64_t end = nanoseconds_now() + time.count * nanoseconds_per_microsecond;
    while (!kfast::sleep_until(end)) {
    }
}

void SteadyClock::sleep_until(Microseconds moment)
{
    const Microseconds begin = now();
    if (reached(begin, moment))
        return;
    const std::int64_t end = asked_ + (moment - begin).count * nanoseconds_per_microsecond;
    while (!was_interrupted() && !kfast::sleep_until(end)) {
    }
}

/// A Linux computer as a board: a display with the driver `P` is wired to its lines.
template <Panel P>
class WiredBoard {
public:
    /// All of them must outlive the board.
    WiredBoard(P& panel, PanelLines& lines, const PanelShow& show)
        : panel_{panel},
          lines_{lines},
          show_{show},
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
    /// The scene was checked, and has the memory that it says it needs.
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

template <Panel P>
void run_until_dark(WiredBoard<P>& board)
{
    try {
        board.wake_up();
        run_scene(board);
    } catch (const Interrupted&) { // in the middle of a picture
    } catch (...) {
        try {
            board.go_dark();
        } catch (const Failure&) { // of the bus that has failed before
        }
        throw;
    }
    board.go_dark();
}

template <DisplayBus Bus>
ShownFrames show_on(Bus bus, PanelLines& lines, const PanelShow& show)
{
    return with_driver<Bus>(show.panel.controller, [&]<Panel P>() {
        P panel = make_panel<P>(bus, show.panel);
        WiredBoard<P> board{panel, lines, show};
        static_assert(ChoosingBoard<WiredBoard<P>> && LiveInputBoard<WiredBoard<P>> &&
                      ListeningBoard<WiredBoard<P>>);
        run_until_dark(board);
        return board.frames();
    });
}

}

ShownFrames show_on_spi(const PanelShow& show, SpiDevice& spi, PanelLines& lines)
{
    return show_on(SpidevBus{spi, lines}, lines, show);
}

ShownFrames show_on_parallel(const PanelShow& show, PanelLines& lines)
{
    return show_on(ParallelBus{lines}, lines, show);
}

}
