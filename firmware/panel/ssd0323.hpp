#pragma once

#include "firmware/bus.hpp"
#include "firmware/panel.hpp"
#include "firmware/start_up.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// Register values as found in drivers of 128x64 modules. What only sibling controllers know (0x23, 0xB0,
/// 0xB4) is left out.
inline constexpr auto ssd0323_start_up = std::to_array<StartUpStep>({
    {0xAE},                                                      // display off
    {0xB3, 1, {0x91}},                                           // clock
    {0xA8, 1, {0x3F}},                                           // 64 rows
    {0xA2, 1, {0x40}},                                           // display offset
    {0xA1, 1, {0x00}},                                           // start line
    {0xAD, 1, {0x02}},                                           // external supply
    {0xA0, 1, {0x52}},                                           // left pixel in the high nibble
    {0x86},                                                      // full current
    {0x81, 1, {0x70}},                                           // contrast
    {0xB2, 1, {0x51}},                                           // row period
    {0xB1, 1, {0x55}},                                           // phase length
    {0xBC, 1, {0x10}},                                           // precharge voltage
    {0xBE, 1, {0x1C}},                                           // VCOMH
    {0xBF, 1, {0x0F}},                                           // VSL
    {0xB8, 8, {0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76}}, // grey table, evenly spaced
    {0xA4},                                                      // show the memory
    {0xAF},                                                      // display on
});

/// Solomon SSD0323: OLED, 128 x 64 pixels, 16 greys, two pixels a byte.
template <DisplayBus Bus>
class Ssd0323 {
public:
    static constexpr PixelFormat format = PixelFormat::grey4;
    static constexpr Size granularity{.width = 2, .height = 1};
    static constexpr int window_bytes = 6;

    /// `bus` must outlive the panel.
    explicit Ssd0323(Bus& bus) : bus_{bus} {}

    Size size() const { return {.width = 128, .height = 64}; }

    template <class Pause>
    void begin(Pause&& pause)
    {
        send_start_up(bus_, ssd0323_start_up, pause);
    }

    void start(Rect area, std::span<const std::byte> pixels)
    {
        select(0x15, area.x / 2, area.width / 2); // columns are counted in bytes
        select(0x75, area.y, area.height);
        bus_.start_data(pixels);
    }

    bool busy() { return bus_.busy(); }

    void set_brightness(std::uint8_t brightness)
    {
        bus_.command(std::array{std::byte{0x81}, static_cast<std::byte>(brightness / 2)}); // seven bits
    }

    template <class Pause>
    void sleep(Pause&&)
    {
        bus_.command(std::array{std::byte{0xAE}});
    }

    template <class Pause>
    void wake(Pause&&)
    {
        bus_.command(std::array{std::byte{0xAF}});
    }

private:
    void select(std::uint8_t axis, int first, int count)
    {
        const auto last = static_cast<std::byte>(first + count - 1);
        bus_.command(std::array{std::byte{axis}, static_cast<std::byte>(first), last});
    }

    Bus& bus_;
};

}
