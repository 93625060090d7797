#pragma once

#include "boards/lm3s6965evb/clock.hpp"
#include "boards/lm3s6965evb/ssi.hpp"
#include "firmware/board.hpp"
#include "firmware/controller_facts.hpp"
#include "firmware/panel/ssd0323.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace kfast::lm3s6965evb {

/// Stellaris LM3S6965 evaluation board as QEMU emulates it, with an SSD0323 display.
///
/// The scene lies in flash from 0x20000 on, or is linked in (KFAST_SCENE). UART0 reports, one line each:
///
///     KFAST <version> lm3s6965evb ssd0323 128x64 grey4
///     SCENE <bytes> <CRC-32>
///     EVENT <name>                                                    when it is passed, before the frame
///     F <time in 1/1024 frame> <CRC-32 of the picture> <bytes sent>   when it has arrived
///     ERROR <name>: <meaning>                                         instead of SCENE
///
/// and listens. `s` starts the scene again, stepped, and is answered with STEP: from then on a frame stands,
/// and the clock with it, until a byte comes, whatever it is. In either mode `r` has the next frame sent
/// whole, and `q` ends and is answered with END.
///
/// The picture is what the display shows, put together from what was sent to it; the bytes count the commands
/// of windows as well.
class Board {
public:
    Board();

    /// Whether there is something to run, for the first time or again.
    bool wants_to_run() const { return mode_ != Mode::ended; }

    Ssd0323<Ssi>& panel() { return panel_; }
    Microseconds now() const;
    void sleep_until(Microseconds moment);

    std::span<const std::byte> scene_bytes();
    std::span<std::byte> block();
    std::array<std::span<std::byte>, 2> bands();

    bool running();
    void scene_started(const SceneView& scene);
    void watch(Rect area, std::span<const std::byte> pixels);
    bool wants_redraw() { return std::exchange(wants_redraw_, false); }
    void event_passed(const EventView& event);
    void frame_shown(FrameReport report);
    void fault(Error error);

private:
    enum class Mode { free_running, stepped, ended };

    void obey(char wish);
    void end();

    Clock clock_;
    Ssi bus_;
    Ssd0323<Ssi> panel_{bus_, facts_of(Controller::ssd0323).usual};
    std::uint32_t bytes_sent_ = 0; ///< since the last report
    bool wants_redraw_ = false;
    Mode mode_ = Mode::free_running;
    bool frame_stands_ = false; ///< stepped: shown and not yet answered
    Microseconds stepped_clock_;
};

}
