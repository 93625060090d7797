#include "boards/vexpress-a9/framebuffer.hpp"

#include "boards/vexpress-a9/registers.hpp"
#include "firmware/run/panel_mirror.hpp"

#include <cstdint>

namespace kfast::vexpress_a9 {
namespace {

static_assert(glass.width % 16 == 0, "the controller counts columns in steps of 16");

constexpr std::uint32_t enabled = 1 << 0;
constexpr std::uint32_t rgb565 = 6 << 1;
constexpr std::uint32_t tft = 1 << 5;
constexpr std::uint32_t red_in_high_bits = 1 << 8; // "BGR"
constexpr std::uint32_t powered = 1 << 11;

alignas(8) PanelMirror<Framebuffer::format, glass.width, glass.height> picture;

}

// How long the edges of a picture last concerns no emulated glass.
void Framebuffer::switch_on()
{
    lcd_timing_0.write((glass.width / 16 - 1) << 2);
    lcd_timing_1.write(glass.height - 1);
    lcd_picture.write(static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(picture.bytes().data())));
    lcd_control.write(enabled | rgb565 | tft | red_in_high_bits | powered);
}

void Framebuffer::start(Rect area, std::span<const std::byte> pixels) { picture.take(area, pixels); }

}
