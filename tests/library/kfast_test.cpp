#include "library/kfast.h"
#include "library/kfast.hpp"

#include "tests/core/stage.hpp"

#include <array>
#include <doctest/doctest.h>
#include <random>
#include <string>
#include <vector>

namespace kfast::test {
namespace {

constexpr std::string_view moving = R"(
kfast 1
canvas 30 20 fps=25 background="#203040" loop=repeat
object dot fill="#ff8000" { key 0 { rect 1 1 8 8 }; key 10 { rect 20 10 8 8 } }
clip back from=4 to=8 loop=once
)";

constexpr int width = 30;
constexpr int height = 20;

/// A player on a block of its own, and a display that remembers what it is handed.
class Screen {
public:
    explicit Screen(std::string_view text, std::size_t gap = 0)
        : scene_{compiled(text)},
          block_(gap + kfast_block_bytes(scene_.data(), scene_.size(), width, height)),
          pixels_(2 * width * height)
    {
        CHECK(kfast_create(&player, block_.data() + gap, block_.size() - gap, scene_.data(), scene_.size(),
                           width, height) == KFAST_OK);
    }

    void draw(std::size_t buffer_bytes)
    {
        std::vector<std::byte> buffer(buffer_bytes);
        rectangles = 0;
        CHECK(kfast_draw_rgb565(player, buffer.data(), buffer.size(), take, this) == KFAST_OK);
    }

    const std::vector<std::byte>& pixels() const { return pixels_; }

    kfast_player* player = nullptr;
    int rectangles = 0;

private:
    static void take(int x, int y, int columns, int rows, const void* pixels, void* user)
    {
        Screen& screen = *static_cast<Screen*>(user);
        const auto* from = static_cast<const std::byte*>(pixels);
        for (int row = y; row < y + rows; ++row, from += 2 * columns)
            std::copy_n(from, 2 * columns, screen.pixels_.begin() + 2 * (row * width + x));
        ++screen.rectangles;
    }

    Bytes scene_;
    std::vector<std::byte> block_;
    std::vector<std::byte> pixels_;
};

Bytes picture(std::string_view text, Time moment)
{
    return Stage{text, {width, height}}.picture<PixelFormat::rgb565>(moment);
}

}

TEST_CASE("the C player draws what the core draws, wherever its block begins and however small its buffer")
{
    for (std::size_t gap = 0; gap < 9; ++gap) {
        Screen screen{moving, gap};
        for (const int frame : {0, 3, 9, 25}) {
            kfast_show(screen.player, frame * KFAST_FRAME);
            screen.draw(2 * width * (1 + gap) + gap);
            CHECK(screen.pixels() == picture(moving, Time::frame(frame)));
        }
    }
}

TEST_CASE("what has been drawn is not drawn again, unless it is asked for")
{
    Screen screen{moving};
    screen.draw(2 * width * height);
    CHECK(screen.rectangles == 1);
    screen.draw(2 * width * height);
    CHECK(screen.rectangles == 0);
    kfast_redraw(screen.player);
    screen.draw(2 * width * height);
    CHECK(screen.rectangles == 1);
    CHECK(screen.pixels() == picture(moving, Time{}));
}

TEST_CASE("times count from the beginning of a clip, and its loop decides about those outside")
{
    Screen screen{moving};
    const auto shows = [&](int frame) {
        screen.draw(2 * width);
        return screen.pixels() == picture(moving, Time::frame(frame));
    };
    CHECK(kfast_choose_clip(screen.player, "back") == KFAST_OK);
    kfast_show(screen.player, KFAST_FRAME);
    CHECK(shows(5));
    kfast_show(screen.player, 100 * KFAST_FRAME);
    CHECK(shows(8));
    CHECK(kfast_choose_clip(screen.player, "forth") == KFAST_NO_SUCH_CLIP);
    kfast_show(screen.player, 2 * KFAST_FRAME);
    CHECK(shows(6));
    CHECK(kfast_choose_clip(screen.player, nullptr) == KFAST_OK);
    kfast_show(screen.player, 12 * KFAST_FRAME);
    CHECK(shows(2));
}

TEST_CASE("milliseconds become frames, for 49 days")
{
    Screen screen{moving};
    const auto shows = [&](std::uint32_t milliseconds, Time moment) {
        kfast_show_after(screen.player, milliseconds);
        screen.draw(2 * width);
        return screen.pixels() == picture(moving, moment);
    };
    CHECK(shows(0, Time{}));
    CHECK(shows(120, Time::frame(3)));
    CHECK(shows(121, {3 * 1024 + 25}));          // 25.6 rounded down
    CHECK(shows(4'294'967'280, Time::frame(2))); // 107,374,182 frames
    CHECK(kfast_choose_clip(screen.player, "back") == KFAST_OK);
    CHECK(shows(120, Time::frame(7)));
    CHECK(shows(4'294'967'280, Time::frame(8)));
}

TEST_CASE("all formats of pixels are handed out")
{
    using Draw = kfast_error (*)(kfast_player*, void*, size_t, kfast_draw_rectangle, void*);
    const auto bytes_of = [](Draw draw, std::size_t row) {
        Screen screen{moving};
        std::vector<std::byte> buffer(row);
        Bytes all;
        const auto take = [](int, int, int columns, int rows, const void*, void* user) {
            *static_cast<int*>(user) += columns * rows;
        };
        int count = 0;
        CHECK(draw(screen.player, buffer.data(), row - 1, take, &count) == KFAST_BUFFER_TOO_SMALL);
        CHECK(count == 0);
        CHECK(draw(screen.player, buffer.data(), row, take, &count) == KFAST_OK);
        return count;
    };
    CHECK(bytes_of(kfast_draw_rgb565, 60) == width * height);
    CHECK(bytes_of(kfast_draw_rgb565_be, 60) == width * height);
    CHECK(bytes_of(kfast_draw_rgb444, 45) == width * height);
    CHECK(bytes_of(kfast_draw_rgb666, 90) == width * height);
    CHECK(bytes_of(kfast_draw_grey4, 15) == width * height);
    CHECK(bytes_of(kfast_draw_mono1, 4) == width * height);
    CHECK(bytes_of(kfast_draw_mono1_dithered, 4) == width * height);
}

TEST_CASE("a buffer at an odd address loses a byte")
{
    Screen screen{moving};
    alignas(2) std::array<std::byte, 62> buffer{};
    const auto take = [](int, int, int, int, const void* pixels, void*) {
        CHECK(reinterpret_cast<std::uintptr_t>(pixels) % 2 == 0);
    };
    CHECK(kfast_draw_rgb565(screen.player, &buffer[1], 60, take, nullptr) == KFAST_BUFFER_TOO_SMALL);
    CHECK(kfast_draw_rgb565(screen.player, &buffer[1], 61, take, nullptr) == KFAST_OK);
    kfast_redraw(screen.player);
    CHECK(kfast_draw_rgb565(screen.player, &buffer[1], 0, take, nullptr) == KFAST_BUFFER_TOO_SMALL);
}

TEST_CASE("nothing is written outside the block that is lent")
{
    const Bytes scene = compiled(moving);
    const std::size_t need = kfast_block_bytes(scene.data(), scene.size(), width, height);
    constexpr std::byte guard{0xA5};
    std::vector<std::byte> memory(need + 64, guard);
    kfast_player* player = nullptr;
    REQUIRE(kfast_create(&player, memory.data() + 31, need, scene.data(), scene.size(), width, height) ==
            KFAST_OK);
    std::array<std::byte, 2 * width + 2> buffer;
    buffer.fill(guard);
    for (int time = 0; time < 20 * 1024; time += 300) {
        kfast_show(player, time);
        kfast_draw_rgb565(
            player, buffer.data() + 1, 2 * width, [](int, int, int, int, const void*, void*) {}, nullptr);
    }
    CHECK(std::ranges::count(std::span{memory}.first(31), guard) == 31);
    CHECK(std::ranges::count(std::span{memory}.last(33), guard) == 33);
    CHECK(buffer.front() == guard);
    CHECK(buffer.back() == guard);
}

TEST_CASE("what cannot be played is refused by name")
{
    const Bytes scene = compiled(moving);
    std::vector<std::byte> block(kfast_block_bytes(scene.data(), scene.size(), width, height));
    kfast_player* player = nullptr;
    const auto refused = [&](const Bytes& bytes, std::size_t lent, int columns, int rows) {
        player = reinterpret_cast<kfast_player*>(&block);
        const kfast_error error =
            kfast_create(&player, block.data(), lent, bytes.data(), bytes.size(), columns, rows);
        CHECK((player == nullptr) == (error != KFAST_OK));
        return error;
    };
    Bytes damaged = scene, newer = scene, other = scene;
    damaged.back() ^= std::byte{1};
    newer[3] = std::byte{99};
    other[0] = std::byte{'P'};
    CHECK(refused(scene, block.size(), width, height) == KFAST_OK);
    for (std::size_t lent = 0; lent + 16 < block.size(); lent += 13)
        CHECK(refused(scene, lent, width, height) == KFAST_BLOCK_TOO_SMALL);
    CHECK(refused({scene.begin(), scene.end() - 1}, block.size(), width, height) == KFAST_TRUNCATED);
    CHECK(refused(damaged, block.size(), width, height) == KFAST_BAD_CHECKSUM);
    CHECK(refused(newer, block.size(), width, height) == KFAST_UNSUPPORTED_VERSION);
    CHECK(refused(other, block.size(), width, height) == KFAST_BAD_MAGIC);
    CHECK(refused(scene, block.size(), 0, height) == KFAST_BAD_PANEL_SIZE);
    CHECK(refused(scene, block.size(), width, 4097) == KFAST_BAD_PANEL_SIZE);
    CHECK(kfast_block_bytes(damaged.data(), damaged.size(), width, height) == 0);
    CHECK(kfast_block_bytes(scene.data(), scene.size(), width, -1) == 0);
}

TEST_CASE("every error has a text that begins with its name")
{
    CHECK(std::string{kfast_error_text(KFAST_OK)} == "ok");
    CHECK(std::string{kfast_error_text(KFAST_TRUNCATED)}.starts_with("truncated: "));
    CHECK(std::string{kfast_error_text(KFAST_BLOCK_TOO_SMALL)}.starts_with("block_too_small: "));
    CHECK(std::string{kfast_error_text(KFAST_BUFFER_TOO_SMALL)}.starts_with("buffer_too_small: "));
    CHECK(std::string{kfast_error_text(KFAST_NO_SUCH_CLIP)}.starts_with("no_such_clip: "));
    CHECK(std::string{kfast_error_text(static_cast<kfast_error>(15))} == "unknown");
}

TEST_CASE("the C++ animation draws the same")
{
    const Bytes scene = compiled(moving);
    std::vector<std::uint32_t> block(*Animation::block_bytes(scene, {width, height}) / 4 + 1);
    const auto lent = std::as_writable_bytes(std::span{block});
    CHECK(Animation::create(scene, {width, height}, lent.first(8)).error() == Error::block_too_small);
    CHECK(Animation::create(std::span{scene}.first(20), {width, height}, lent).error() == Error::truncated);
    auto animation = Animation::create(scene, {width, height}, lent);
    REQUIRE(animation);
    CHECK_FALSE(animation->choose_clip("forth"));
    CHECK(animation->choose_clip("back"));
    animation->show_after(40);
    std::vector<std::byte> buffer(2 * width * height);
    Bytes pixels;
    CHECK_FALSE(
        animation->draw<PixelFormat::rgb565>(std::span{buffer}.first(2 * width - 1), [](Rect, auto) {}));
    CHECK(animation->draw<PixelFormat::rgb565>(buffer, [&](Rect area, std::span<const std::byte> part) {
        CHECK(area == Rect{0, 0, width, height});
        pixels.assign(part.begin(), part.end());
    }));
    CHECK(pixels == picture(moving, Time::frame(5)));
}

}
