#include "library/kfast.h"

#include "tests/core/everything.hpp"
#include "tests/core/filling.hpp"
#include "tests/core/player_fixture.hpp"
#include "tests/library/screen.hpp"

#include <doctest/doctest.h>
#include <random>
#include <vector>

namespace kfast::test {
namespace {

/// A display of one format, as its driver sees it. It starts with rubbish in it.
template <PixelFormat format>
class Display {
public:
    explicit Display(Size size)
        : size_{size},
          bytes_(row_bytes(format, size.width) * static_cast<std::size_t>(size.height), std::byte{0x5A})
    {
    }

    static void take(int x, int y, int columns, int rows, const void* pixels, void* user)
    {
        Display& display = *static_cast<Display*>(user);
        constexpr int unit = pixels_in_whole_bytes(format);
        CHECK(x % unit == 0);
        CHECK((columns % unit == 0 || x + columns == display.size_.width));
        const std::size_t length = row_bytes(format, columns);
        const std::size_t stride = row_bytes(format, display.size_.width);
        const auto* from = static_cast<const std::byte*>(pixels);
        for (int row = y; row < y + rows; ++row, from += length)
            std::copy_n(from, length,
                        &display.bytes_.at(stride * static_cast<std::size_t>(row) + row_bytes(format, x)));
        display.taken_ += length * static_cast<std::size_t>(rows);
    }

    Bytes shown() const { return without_filling(format, size_, bytes_); }
    std::size_t taken() const { return taken_; }

private:
    Size size_;
    Bytes bytes_;
    std::size_t taken_ = 0; ///< bytes
};

/// Random times, by small and large steps, with buffers at any place and of any size: from the least on.
template <PixelFormat format>
void check_against_redraws(Draw draw, Size panel, unsigned seed)
{
    std::mt19937 random{seed};
    const Bytes scene = compiled(everything);
    std::vector<std::byte> block(kfast_block_bytes(scene.data(), scene.size(), panel.width, panel.height));
    kfast_player* player = nullptr;
    REQUIRE(kfast_create(&player, block.data(), block.size(), scene.data(), scene.size(), panel.width,
                         panel.height) == KFAST_OK);
    PlayerFixture fresh{scene, panel};
    Display<format> display{panel};
    std::int32_t time = 0;
    for (int round = 0; round < 60; ++round) {
        time = random() % 3 == 0 ? static_cast<std::int32_t>(random() % 60'000)
                                 : time + static_cast<std::int32_t>(random() % 700);
        if (random() % 8 == 0)
            CHECK(kfast_redraw(player) == KFAST_OK);
        CHECK(kfast_show(player, time) == KFAST_OK);
        const std::size_t place = random() % 4;
        const std::size_t lost = bits_per_pixel(format) == 16 ? place % 2 : 0;
        const std::size_t bytes = lost + row_bytes(format, panel.width) * (1 + random() % 5) + random() % 7;
        Bytes buffer(place + bytes);
        CHECK(draw(player, &buffer[place], bytes, display.take, &display) == KFAST_OK);
        REQUIRE(display.shown() == without_filling(format, panel, fresh.picture<format>({time})));
    }
}

}

TEST_CASE("a display that takes what changes shows what a full redraw would")
{
    for (unsigned seed = 0; seed < 3; ++seed)
        for (const Size panel : {Size{64, 40}, Size{61, 33}}) {
            check_against_redraws<PixelFormat::rgb565>(kfast_draw_rgb565, panel, seed);
            check_against_redraws<PixelFormat::rgb444>(kfast_draw_rgb444, panel, seed);
            check_against_redraws<PixelFormat::rgb666>(kfast_draw_rgb666, panel, seed);
            check_against_redraws<PixelFormat::grey4>(kfast_draw_grey4, panel, seed);
            check_against_redraws<PixelFormat::mono1>(kfast_draw_mono1, panel, seed);
            check_against_redraws<PixelFormat::mono1_dithered>(kfast_draw_mono1_dithered, panel, seed);
        }
}

TEST_CASE("only what changes is handed out")
{
    const Bytes scene = compiled("kfast 1\ncanvas 60 40 frames=20\n"
                                 "object o fill=red { rect 5 5 10 10; key 0 x=0; key 10 x=20 }\n");
    std::vector<std::byte> block(kfast_block_bytes(scene.data(), scene.size(), 60, 40));
    kfast_player* player = nullptr;
    REQUIRE(kfast_create(&player, block.data(), block.size(), scene.data(), scene.size(), 60, 40) ==
            KFAST_OK);
    Display<PixelFormat::rgb565> display{{60, 40}};
    std::vector<std::byte> buffer(2 * 60 * 8);
    const auto drawn = [&] {
        const std::size_t before = display.taken();
        kfast_draw_rgb565(player, buffer.data(), buffer.size(), display.take, &display);
        return display.taken() - before;
    };
    CHECK(drawn() == 2 * 60 * 40);
    kfast_show(player, KFAST_FRAME);
    CHECK(drawn() <= 2 * 14 * 10); // two columns at both sides
    kfast_show(player, KFAST_FRAME);
    CHECK(drawn() == 0);
    kfast_redraw(player);
    CHECK(drawn() == 2 * 60 * 40);
}

}
