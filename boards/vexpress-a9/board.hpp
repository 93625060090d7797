#pragma once

#include "boards/vexpress-a9/clock.hpp"
#include "boards/vexpress-a9/framebuffer.hpp"
#include "boards/vexpress-a9/uart.hpp"
#include "firmware/serial/console_board.hpp"

#include <array>
#include <cstddef>
#include <span>

namespace kfast::vexpress_a9 {

/// ARM Versatile Express with a Cortex-A9 as QEMU emulates it: a picture in RAM, 16 bits of colour. UART0 is
/// its console. The scene is in RAM from 0x61000000 on.
class Board : public ConsoleBoard<const Pl011, Clock, Framebuffer, glass> {
public:
    Board();

    Framebuffer& panel() { return panel_; }

    std::span<const std::byte> scene_bytes();
    std::span<std::byte> block();
    std::array<std::span<std::byte>, 2> bands();

    void scene_started(const SceneView& scene) { report_scene(scene_bytes().first(scene.size())); }

private:
    Framebuffer panel_;
};

}
