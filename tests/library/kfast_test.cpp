#include "library/kfast.h"

#include "host/compiler/write/header.hpp"
#include "library/kfast.hpp"
#include "tests/core/player_fixture.hpp"
#include "tests/library/screen.hpp"

#include <array>
#include <doctest/doctest.h>
#include <string>
#include <vector>

namespace kfast::test {

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

TEST_CASE("a program asks whether a picture has all of its detail")
{
    CHECK(kfast_is_coarse(Screen{moving}.player) == 0);
    std::vector<std::byte> scarce =
        compiled("kfast 1\ncanvas 30 20\nobject disc fill=white { circle 15 10 r=9 }");
    set_outline_needs(scarce, {.bytes = 128, .borders = 20});
    std::vector<std::byte> block(kfast_block_bytes(scarce.data(), scarce.size(), width, height));
    kfast_player* player = nullptr;
    CHECK(kfast_create(&player, block.data(), block.size(), scarce.data(), scarce.size(), width, height) ==
          KFAST_OK);
    CHECK(kfast_is_coarse(player) == 1);
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
               PlayerFixture{std::string{begin} + "object o stroke=lime { " + shapes + " }", {width, height}}
                   .picture({});
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
    const auto refused = [&](const Bytes& bytes, std::size_t borrowed, int columns, int rows) {
        player = reinterpret_cast<kfast_player*>(&block);
        const kfast_error error =
            kfast_create(&player, block.data(), borrowed, bytes.data(), bytes.size(), columns, rows);
        CHECK((player == nullptr) == (error != KFAST_OK));
        return error;
    };
    Bytes damaged = scene, newer = scene, other = scene;
    damaged.back() ^= std::byte{1};
    newer[3] = std::byte{99};
    other[0] = std::byte{'P'};
    CHECK(refused(scene, block.size(), width, height) == KFAST_OK);
    for (std::size_t borrowed = 0; borrowed + 16 < block.size(); borrowed += 13)
        CHECK(refused(scene, borrowed, width, height) == KFAST_BLOCK_TOO_SMALL);
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
    CHECK(kfast_is_coarse(player) == 0);
    for (const Draw draw : {kfast_draw_rgb565, kfast_draw_rgb565_be, kfast_draw_rgb444, kfast_draw_rgb666,
                            kfast_draw_grey4, kfast_draw_mono1, kfast_draw_mono1_dithered})
        CHECK(draw(player, buffer.data(), buffer.size(), take, nullptr) == KFAST_NULL_POINTER);

    REQUIRE(kfast_create(&player, block.data(), block.size(), scene.data(), scene.size(), width, height) ==
            KFAST_OK);
    CHECK(kfast_draw_rgb565(player, nullptr, buffer.size(), take, nullptr) == KFAST_NULL_POINTER);
    CHECK(kfast_draw_rgb565(player, buffer.data(), buffer.size(), nullptr, nullptr) == KFAST_NULL_POINTER);
    CHECK(kfast_draw_rgb565(player, buffer.data(), 0, take, nullptr) == KFAST_BUFFER_TOO_SMALL);
}

TEST_CASE("a player has the features that it was made with, and refuses by name what needs others")
{
    const std::vector<std::byte> stroked =
        compiled("kfast 1\ncanvas 24 16\nobject o stroke=white width=3 { line 2 2 20 12 }");
    std::vector<std::byte> block(kfast_block_bytes(stroked.data(), stroked.size(), width, height));
    const auto created = [&](const kfast_features* features) {
        kfast_player* player = nullptr;
        const kfast_error error = kfast_create_with(&player, block.data(), block.size(), stroked.data(),
                                                    stroked.size(), width, height, features);
        CHECK((player != nullptr) == (error == KFAST_OK));
        return error;
    };
    kfast_features features{};
    CHECK(created(&features) == KFAST_NEEDS_STROKES);
    CHECK(std::string{kfast_error_text(KFAST_NEEDS_STROKES)}.starts_with("needs_strokes: "));
    CHECK(std::string{kfast_error_text(KFAST_NEEDS_DRAWINGS)}.starts_with("needs_drawings: "));
    CHECK(std::string{kfast_error_text(KFAST_NEEDS_TRIMS)}.starts_with("needs_trims: "));
    CHECK(std::string{kfast_error_text(KFAST_NEEDS_SPRINGS)}.starts_with("needs_springs: "));
    features.strokes = &kfast_strokes;
    CHECK(created(&features) == KFAST_OK);
    CHECK(created(nullptr) == KFAST_NULL_POINTER);
    const auto needed = [&](const kfast_features* given) {
        return kfast_block_bytes_with(stroked.data(), stroked.size(), width, height, given);
    };
    const kfast_features none{};
    CHECK(needed(&features) == block.size());
    CHECK(needed(&none) == 0);
    CHECK(needed(nullptr) == 0);
    CHECK(Animation::block_bytes(stroked, {width, height}, Features{}).error() == Error::needs_strokes);
    CHECK(Animation::create(stroked, {width, height}, {}, Fit::contain, Features{}).error() ==
          Error::needs_strokes);
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
    CHECK(std::string{kfast_error_text(static_cast<kfast_error>(31))} == "unknown");
}

TEST_CASE("a text is what was told last")
{
    const std::string label =
        "kfast 1\ncanvas 24 16\ninput t kind=text glyphs=\"0-9\" max=2 default=\"7\"\ninput n\n"
        "object o fill=red stroke=white { text input=t at=\"1,14\" size=16 font=hershey-sans; track x "
        "input=n { at 0 0; at 1 3 "
        "} }";
    const auto seen = [&label](std::string_view text) {
        PlayerFixture fixture{label, {width, height}};
        fixture.player.set_text(0, text);
        return fixture.picture<PixelFormat::rgb565>({});
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

}
