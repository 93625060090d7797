#include "host/preview/painter/painter.hpp"
#include "host/preview/window/window_layout.hpp"
#include "tests/host/preview/recording_painter.hpp"

#include <doctest/doctest.h>
#include <vector>

namespace kfast::test {

TEST_CASE("the parts of a window lie beside each other and fill it")
{
    for (const Size window : window_sizes())
        for (const bool report : {false, true})
            for (const int wanted : {0, 60, 10'000}) {
                const WindowLayout parts = window_layout(
                    window, {.side = true, .side_at_any_width = report, .time_line_height = wanted});
                const std::vector<Rect> all{parts.picture, parts.side, parts.time_line, parts.status};
                int pixels = 0;
                for (std::size_t i = 0; i < all.size(); ++i) {
                    CHECK(lies_within(all[i], {0, 0, window.width, window.height}));
                    pixels += all[i].width * all[i].height;
                    for (std::size_t j = 0; j < i; ++j)
                        CHECK(is_empty(common(all[i], all[j])));
                }
                CHECK(pixels == window.width * window.height);
            }
}

TEST_CASE("a window of 320 by 240 still shows the picture, a time line and the status")
{
    const WindowLayout parts = window_layout({320, 240}, {.side = true, .time_line_height = 200});
    CHECK(parts.picture.width == 320);
    CHECK(parts.picture.height >= 120);
    CHECK(parts.time_line.height >= 60);
    CHECK(parts.status.height == 24);
}

TEST_CASE("the side is shown where there is room, and in a narrow window if its report is wanted")
{
    CHECK(window_layout({900, 600}, {.side = true}).side.width == 270);
    CHECK(window_layout({900, 600}, {}).side.width == 0);
    CHECK(window_layout({500, 600}, {.side = true}).side.width == 0);
    CHECK(window_layout({320, 240}, {.side_at_any_width = true}).side.width == 160);
}

TEST_CASE("a time line takes what it needs, but leaves the picture more than itself")
{
    CHECK(window_layout({900, 600}, {.time_line_height = 100}).time_line.height == 100);
    CHECK(window_layout({900, 600}, {.time_line_height = 900}).time_line.height == 230);
}

TEST_CASE("a time line gives up rows for a larger picture, but only as far as that helps")
{
    const auto height = [](Size panel, int margin, int spare) {
        return window_layout({960, 720}, {.side = true,
                                          .time_line_height = 260,
                                          .spare_time_line_height = spare,
                                          .panel = panel,
                                          .picture_margin = margin})
            .time_line.height;
    };
    CHECK(height({240, 240}, 12, 160) == 696 - 480 - 24);
    CHECK(height({240, 240}, 30, 160) == 696 - 480 - 60);
    CHECK(height({240, 240}, 12, 60) == 260); // 480 do not fit beside that
    CHECK(height({128, 64}, 12, 160) == 260); // the side leaves no more
    CHECK(height({2000, 3000}, 12, 160) == 100);
}

}
