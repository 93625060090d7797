#include "boards/vexpress-a9/framebuffer.hpp"

#include "boards/vexpress-a9/registers.hpp"
#include "firmware/run/panel_mirror.hpp"

#include <cstdint>

namespace kfast::vexpress_a9 {
namespace {

static_assert(glass.width % 16 == 0, "the controller counts columns in steps of 16");

constexpr std::uint32_t lcd_en = 1 << 0;
constexpr std::uint32_t lcd_bpp_16_565 = 6 << 1;
constexpr std::uint32_t lcd_tft = 1 << 5;
constexpr std::uint32_t lcd_bgr = 1 << 8; // red in the high bits
constexpr std::uint32_t lcd_pwr = 1 << 11;

alignas(8) PanelMirror<Framebuffer::format, glass.width, glass.height> picture;

}

// The duration of a picture's edges does not matter to an emulated glass.
void Framebuffer::switch_on()
{
    lcd_timing0.write((glass.width / 16 - 1) << 2);
    lcd_timing1.write(glass.height - 1);
    lcd_upbase.write(static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(picture.bytes().data())));
    lcd_control.write(lcd_en | lcd_bpp_16_565 | lcd_tft | lcd_bgr | lcd_pwr);
}

void Framebuffer::start(Rect area, std::span<const std::byte> pixels) { picture.take(area, pixels); }

}
