#pragma once

#include "boards/lm3s6965evb/clock.hpp"
#include "boards/lm3s6965evb/ssi.hpp"
#include "boards/lm3s6965evb/uart.hpp"
#include "firmware/panel/ssd0323.hpp"
#include "firmware/serial/console_board.hpp"
#include "firmware/settings/controller_facts.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace kfast::lm3s6965evb {

using Display = Ssd0323<Ssi>;
inline constexpr Size glass{.width = 128, .height = 64};

/// Stellaris LM3S6965 evaluation board as QEMU emulates it, with an SSD0323 display. UART0 is its console.
///
/// The scene is in flash from 0x24000 on, or is linked in (KFAST_SCENE).
class Board : public ConsoleBoard<const Pl011, Clock, Display, glass> {
public:
    Board();

    Display& panel() { return panel_; }

    std::span<const std::byte> scene_bytes();
    std::span<std::byte> block();
    std::array<std::span<std::byte>, 2> bands();

    void scene_started(const SceneView& scene) { report_scene(scene_bytes().first(scene.size())); }

private:
    Ssi bus_;
    Display panel_{bus_, facts_of(Controller::ssd0323).default_value};
};

}
