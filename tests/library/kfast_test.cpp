#include "library/kfast.h"
#include "library/kfast.hpp"

#include "tests/core/everything.hpp"
#include "tests/core/filling.hpp"
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

/// The dot goes by one input, and blinks by another.
constexpr std::string_view steered = R"(
kfast 1
canvas 30 20 background="#203040"
input gaze min=-1 max=1 default=0.5
input open min=0 max=100
group look {
    track x input=gaze { at -1 0; at 1 20 }
    object dot fill="#ff8000" input=open { key 0 { rect 1 1 8 2 }; key 100 { rect 1 1 8 12 } }
}
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

/// With inputs at these places.
Bytes picture(std::string_view text, Time gaze, Time open)
{
    Stage stage{text, {width, height}};
    stage.player.set_input(0, gaze);
    stage.player.set_input(1, open);
    return stage.picture<PixelFormat::rgb565>({});
}

using Draw = kfast_error (*)(kfast_player*, void*, size_t, kfast_draw_rectangle, void*);

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
    Stage fresh{scene, panel};
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

TEST_CASE("inputs stand where they are set, in the unit of the scene, and at their usual values before")
{
    Screen screen{steered};
    const auto shows = [&](int gaze, int open) {
        CHECK(kfast_show(screen.player, 0) == KFAST_OK);
        screen.draw(2 * width);
        return screen.pixels() == picture(steered, {gaze}, {open});
    };
    CHECK(shows(49152, 0));
    CHECK(kfast_set_input(screen.player, "gaze", -1000) == KFAST_OK);
    CHECK(shows(0, 0));
    CHECK(kfast_set_input(screen.player, "open", 25'000) == KFAST_OK);
    CHECK(shows(0, 16384));
    CHECK(kfast_set_input(screen.player, "gaze", 250) == KFAST_OK);
    CHECK(shows(40960, 16384));
    CHECK(kfast_set_input(screen.player, "gaze", INT32_MAX) == KFAST_OK);
    CHECK(shows(65536, 16384));
    CHECK(kfast_set_input(screen.player, "gaze", INT32_MIN) == KFAST_OK);
    CHECK(shows(0, 16384));
    CHECK(kfast_set_input(screen.player, "gase", 1000) == KFAST_NO_SUCH_INPUT);
    CHECK(kfast_set_input(screen.player, "", 1000) == KFAST_NO_SUCH_INPUT);
    CHECK(kfast_set_input(screen.player, nullptr, 1000) == KFAST_NULL_POINTER);
    CHECK(shows(0, 16384));
}

TEST_CASE("an input is seen from the next show() on, and draws only what it moves")
{
    Screen screen{steered};
    screen.draw(2 * width * height);
    CHECK(kfast_set_input(screen.player, "gaze", 1000) == KFAST_OK);
    screen.draw(2 * width * height);
    CHECK(screen.rectangles == 0);
    CHECK(kfast_show(screen.player, 0) == KFAST_OK);
    screen.draw(2 * width * height);
    CHECK(screen.rectangles > 0);
    CHECK(screen.pixels() == picture(steered, {65536}, {}));
}

TEST_CASE("a drawing shows what it is set to, stroke by stroke, and its usual strokes before")
{
    constexpr std::string_view begin = "kfast 1\ncanvas 30 20\n";
    const std::string plot = std::string{begin} +
                             "input n\ninput curve kind=drawing points=5 strokes=2 { line 1 1 9 9 }\n" +
                             "object o stroke=lime live=curve { track x input=n { at 0 0; at 1 9 } }";
    Screen screen{plot};
    const auto shows = [&](const std::string& shapes) {
        CHECK(kfast_show(screen.player, 0) == KFAST_OK);
        screen.draw(2 * width);
        return screen.pixels() ==
               Stage{std::string{begin} + "object o stroke=lime { " + shapes + " }", {width, height}}.picture(
                   {});
    };
    CHECK(shows("line 1 1 9 9"));
    const kfast_point points[] = {{16, 16}, {160, 32}, {24, 80}, {16, 240}, {320, 240}, {0, 0}};
    const std::uint16_t counts[] = {3, 2, 1};
    CHECK(kfast_set_drawing(screen.player, "curve", points, counts, 2) == KFAST_OK);
    CHECK(shows("line 1 1 10 2 1.5 5; line 1 15 20 15"));
    CHECK(kfast_set_drawing(screen.player, "curve", points, counts, 3) == KFAST_DRAWING_TOO_LARGE);
    CHECK(kfast_set_drawing(screen.player, "curse", points, counts, 2) == KFAST_NO_SUCH_INPUT);
    CHECK(kfast_set_drawing(screen.player, "n", points, counts, 2) == KFAST_NO_SUCH_INPUT);
    CHECK(kfast_set_input(screen.player, "curve", 1) == KFAST_NO_SUCH_INPUT);
    CHECK(kfast_set_drawing(nullptr, "curve", points, counts, 2) == KFAST_NULL_POINTER);
    CHECK(kfast_set_drawing(screen.player, nullptr, points, counts, 2) == KFAST_NULL_POINTER);
    CHECK(kfast_set_drawing(screen.player, "curve", nullptr, counts, 2) == KFAST_NULL_POINTER);
    CHECK(kfast_set_drawing(screen.player, "curve", points, nullptr, 2) == KFAST_NULL_POINTER);
    CHECK(shows("line 1 1 10 2 1.5 5; line 1 15 20 15"));
    CHECK(kfast_set_drawing(screen.player, "curve", nullptr, nullptr, 0) == KFAST_OK);
    CHECK(shows("empty"));
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

TEST_CASE("a buffer at an odd address loses a byte where pixels have 16 bits")
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
    CHECK(refused(scene, block.size(), 0, 0) == KFAST_BAD_PANEL_SIZE);
    CHECK(refused(scene, block.size(), 4097, 4097) == KFAST_BAD_PANEL_SIZE);
    CHECK(refused(scene, block.size(), 4096, 4096) == KFAST_BLOCK_TOO_SMALL);
    CHECK(refused({}, block.size(), width, height) != KFAST_OK);
    CHECK(refused(scene, block.size(), width, 4097) == KFAST_BAD_PANEL_SIZE);
    CHECK(kfast_block_bytes(damaged.data(), damaged.size(), width, height) == 0);
    CHECK(kfast_block_bytes(scene.data(), scene.size(), width, -1) == 0);
}

TEST_CASE("null pointers are refused")
{
    const Bytes scene = compiled(moving);
    std::vector<std::byte> block(kfast_block_bytes(scene.data(), scene.size(), width, height));
    kfast_player* player = nullptr;
    CHECK(kfast_block_bytes(nullptr, scene.size(), width, height) == 0);
    CHECK(kfast_create(nullptr, block.data(), block.size(), scene.data(), scene.size(), width, height) ==
          KFAST_NULL_POINTER);
    CHECK(kfast_create(&player, nullptr, block.size(), scene.data(), scene.size(), width, height) ==
          KFAST_NULL_POINTER);
    CHECK(kfast_create(&player, block.data(), block.size(), nullptr, scene.size(), width, height) ==
          KFAST_NULL_POINTER);
    CHECK(player == nullptr);

    std::array<std::byte, 2 * width> buffer{};
    const auto take = [](int, int, int, int, const void*, void*) { FAIL("nothing is to be drawn"); };
    CHECK(kfast_choose_clip(player, nullptr) == KFAST_NULL_POINTER); // never made
    CHECK(kfast_choose_clip(player, "back") == KFAST_NULL_POINTER);
    CHECK(kfast_set_input(player, "gaze", 0) == KFAST_NULL_POINTER);
    CHECK(kfast_show(player, 0) == KFAST_NULL_POINTER);
    CHECK(kfast_show_after(player, 0) == KFAST_NULL_POINTER);
    CHECK(kfast_redraw(player) == KFAST_NULL_POINTER);
    for (const Draw draw : {kfast_draw_rgb565, kfast_draw_rgb565_be, kfast_draw_rgb444, kfast_draw_rgb666,
                            kfast_draw_grey4, kfast_draw_mono1, kfast_draw_mono1_dithered})
        CHECK(draw(player, buffer.data(), buffer.size(), take, nullptr) == KFAST_NULL_POINTER);

    REQUIRE(kfast_create(&player, block.data(), block.size(), scene.data(), scene.size(), width, height) ==
            KFAST_OK);
    CHECK(kfast_draw_rgb565(player, nullptr, buffer.size(), take, nullptr) == KFAST_NULL_POINTER);
    CHECK(kfast_draw_rgb565(player, buffer.data(), buffer.size(), nullptr, nullptr) == KFAST_NULL_POINTER);
    CHECK(kfast_draw_rgb565(player, buffer.data(), 0, take, nullptr) == KFAST_BUFFER_TOO_SMALL);
}

TEST_CASE("every error has a text that begins with its name")
{
    CHECK(std::string{kfast_error_text(KFAST_OK)} == "ok");
    CHECK(std::string{kfast_error_text(KFAST_TRUNCATED)}.starts_with("truncated: "));
    CHECK(std::string{kfast_error_text(KFAST_BLOCK_TOO_SMALL)}.starts_with("block_too_small: "));
    CHECK(std::string{kfast_error_text(KFAST_BUFFER_TOO_SMALL)}.starts_with("buffer_too_small: "));
    CHECK(std::string{kfast_error_text(KFAST_NO_SUCH_CLIP)}.starts_with("no_such_clip: "));
    CHECK(std::string{kfast_error_text(KFAST_DRAWING_TOO_LARGE)}.starts_with("drawing_too_large: "));
    CHECK(std::string{kfast_error_text(KFAST_NO_SUCH_INPUT)}.starts_with("no_such_input: "));
    CHECK(std::string{kfast_error_text(KFAST_NULL_POINTER)}.starts_with("null_pointer: "));
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

TEST_CASE("the C++ animation takes drawings by name")
{
    const Bytes scene =
        compiled("kfast 1\ncanvas 30 20\ninput curve kind=drawing points=3\nobject o stroke=lime live=curve");
    Bytes block(*Animation::block_bytes(scene, {width, height}));
    auto animation = Animation::create(scene, {width, height}, block);
    REQUIRE(animation);
    const std::vector<LivePoint> points{{16, 16}, {160, 32}, {24, 80}};
    const std::array<LiveStroke, 2> strokes{points, points};
    CHECK(animation->set_drawing("curve", std::span{strokes}.first(1)));
    CHECK_FALSE(animation->set_drawing("curve", strokes));
    CHECK_FALSE(animation->set_drawing("curse", std::span{strokes}.first(1)));
    CHECK_FALSE(animation->drawing("curse"));
    CHECK(animation->drawing("curve")->stroke(0).size() == 3);
    animation->drawing("curve")->add({1, 2});
    animation->show_next_drawing("curve");
    CHECK(animation->drawing("curve")->stroke(0).size() == 1);
}

TEST_CASE("a text is what was told last")
{
    const std::string label =
        "kfast 1\ncanvas 24 16\ninput t kind=text glyphs=\"0-9\" max=2 default=\"7\"\ninput n\n"
        "object o fill=red stroke=white { text input=t at=\"1,14\" size=16; track x input=n { at 0 0; at 1 3 "
        "} }";
    const auto seen = [&label](std::string_view text) {
        Stage stage{label, {width, height}};
        stage.player.set_text(0, text);
        return stage.picture<PixelFormat::rgb565>({});
    };
    Screen screen{label};
    const auto shows = [&](std::string_view text) {
        CHECK(kfast_show(screen.player, 0) == KFAST_OK);
        screen.draw(2 * width);
        return screen.pixels() == seen(text);
    };
    CHECK(shows("7"));
    CHECK(kfast_set_text(screen.player, "t", "42") == KFAST_OK);
    CHECK(shows("42"));
    CHECK(kfast_set_text(screen.player, "t", "1x99") == KFAST_OK);
    CHECK(shows("19"));
    CHECK(kfast_set_text(screen.player, "n", "5") == KFAST_NO_SUCH_INPUT);
    CHECK(kfast_set_input(screen.player, "t", 1000) == KFAST_NO_SUCH_INPUT);
    CHECK(kfast_set_text(screen.player, "u", "5") == KFAST_NO_SUCH_INPUT);
    CHECK(kfast_set_text(screen.player, nullptr, "5") == KFAST_NULL_POINTER);
    CHECK(kfast_set_text(screen.player, "t", nullptr) == KFAST_NULL_POINTER);
    CHECK(kfast_set_text(nullptr, "t", "5") == KFAST_NULL_POINTER);
    CHECK(shows("19"));
}

TEST_CASE("the C++ animation takes inputs by name")
{
    const Bytes scene = compiled(steered);
    std::vector<std::uint32_t> block(*Animation::block_bytes(scene, {width, height}) / 4 + 1);
    auto animation = Animation::create(scene, {width, height}, std::as_writable_bytes(std::span{block}));
    REQUIRE(animation);
    CHECK_FALSE(animation->set_input("gase", 0));
    CHECK(animation->set_input("open", 50'000));
    CHECK(animation->set_input("gaze", -250));
    animation->show({});
    std::vector<std::byte> buffer(2 * width * height);
    Bytes pixels;
    CHECK(animation->draw<PixelFormat::rgb565>(
        buffer, [&](Rect, std::span<const std::byte> part) { pixels.assign(part.begin(), part.end()); }));
    CHECK(pixels == picture(steered, {24576}, {32768}));
}

}
