#include "firmware/run/panel_show.hpp"

#include "tests/firmware/run/numbered_rows.hpp"
#include "tests/firmware/run/slow_board.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

namespace kfast::test {
namespace {

/// An area filled with a byte.
struct Patch {
    Rect area;
    std::byte fill{};
};

/// Draws patches, the next few with every call, and spoils what the buffer held before.
class Patches {
public:
    Patches(const SlowPanel& panel, std::vector<std::vector<Patch>> strips)
        : panel_{panel}, strips_{std::move(strips)}
    {
    }

    template <PixelFormat format>
    std::span<const Change> draw_changes(std::span<std::byte> pixels, Size granularity, int window_bytes)
    {
        CHECK(granularity == SlowPanel::granularity);
        CHECK(window_bytes == SlowPanel::window_bytes);
        was_sending.push_back(panel_.is_sending());
        std::ranges::fill(pixels, std::byte{0xEE});
        changes_.clear();
        if (was_sending.size() <= strips_.size())
            for (const Patch& patch : strips_[was_sending.size() - 1]) {
                const auto count =
                    row_bytes(format, patch.area.width) * static_cast<std::size_t>(patch.area.height);
                std::ranges::fill(pixels.first(count), patch.fill);
                changes_.push_back({patch.area, pixels.first(count)});
                pixels = pixels.subspan(count);
            }
        return changes_;
    }

    std::vector<bool> was_sending; ///< at each call

private:
    const SlowPanel& panel_;
    std::vector<std::vector<Patch>> strips_;
    std::vector<Change> changes_;
};

/// Notes how many areas have been sent when it listens.
class CuriousBoard : public SlowBoard {
public:
    using SlowBoard::SlowBoard;

    void listen() { heard_after.push_back(panel().areas.size()); }

    std::vector<std::size_t> heard_after;
};

static_assert(ListeningBoard<CuriousBoard>);
static_assert(!ListeningBoard<SlowBoard>);

}

TEST_CASE("the bands make up the picture although each is sent while the next is drawn")
{
    SlowBoard board{12};
    NumberedRows player;
    draw_frame(board, player);
    CHECK(board.panel().shown == ten_numbered_rows());
    CHECK(board.panel().areas == std::vector<Rect>{{0, 0, 6, 4}, {0, 4, 6, 4}, {0, 8, 6, 2}});
}

TEST_CASE("areas of one buffer are sent one after another, the last while the other buffer is drawn")
{
    SlowBoard board{12};
    Patches player{
        board.panel(),
        {{{{0, 0, 2, 2}, std::byte{0x11}}, {{4, 0, 2, 4}, std::byte{0x22}}, {{0, 2, 2, 2}, std::byte{0x33}}},
         {{{0, 4, 6, 2}, std::byte{0x44}}},
         {{{2, 6, 4, 2}, std::byte{0x55}}, {{0, 8, 2, 2}, std::byte{0x66}}}}};
    draw_frame(board, player);
    CHECK(board.panel().shown ==
          std::array<std::byte, 30>{std::byte{0x11}, std::byte{},     std::byte{0x22},
                                    std::byte{0x11}, std::byte{},     std::byte{0x22}, //
                                    std::byte{0x33}, std::byte{},     std::byte{0x22},
                                    std::byte{0x33}, std::byte{},     std::byte{0x22}, //
                                    std::byte{0x44}, std::byte{0x44}, std::byte{0x44},
                                    std::byte{0x44}, std::byte{0x44}, std::byte{0x44}, //
                                    std::byte{},     std::byte{0x55}, std::byte{0x55},
                                    std::byte{},     std::byte{0x55}, std::byte{0x55}, //
                                    std::byte{0x66}, std::byte{},     std::byte{},
                                    std::byte{0x66}, std::byte{},     std::byte{}});
    CHECK(player.was_sending == std::vector{false, true, true, true});
    CHECK_FALSE(board.panel().is_sending());
}

TEST_CASE("a band has as many rows as its buffer holds and the panel's granularity allows")
{
    SlowBoard board{17};
    CHECK(rows_per_band(board.panel(), 17) == 4);
    CHECK(rows_per_band(board.panel(), 5) == 0);
}

TEST_CASE("a watching board sees every area and its pixels, in the order in which they are sent")
{
    SlowBoard board{12};
    NumberedRows player;
    draw_frame(board, player);
    CHECK(board.watched_areas == board.panel().areas);
    CHECK(std::ranges::equal(board.watched, ten_numbered_rows()));
}

TEST_CASE("a board listens before each part of a picture")
{
    CuriousBoard board{12};
    NumberedRows player;
    draw_frame(board, player);
    CHECK(board.heard_after == std::vector<std::size_t>{0, 1, 2, 3});
}

}
