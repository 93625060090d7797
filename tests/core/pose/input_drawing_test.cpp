#include "core/pose/input_drawing.hpp"

#include "host/player/received_drawing.hpp"

#include <doctest/doctest.h>

#include <random>

namespace kfast::test {
namespace {

/// A drawing in memory of its own, with a guard behind.
struct Sheet {
    static constexpr std::uint32_t guard = 0xA5A5'A5A5;

    DrawingInput limits;
    std::vector<std::uint32_t> memory;
    InputDrawing drawing;

    Sheet(std::uint32_t strokes, std::uint32_t points)
        : limits{.strokes = strokes, .points = points},
          memory(InputDrawing::bytes_for(limits) / 4 + 1),
          drawing{bytes(), limits}
    {
        memory.back() = guard;
    }

    std::span<std::byte> bytes()
    {
        return std::as_writable_bytes(std::span{memory}).first(InputDrawing::bytes_for(limits));
    }
    bool set(const ReceivedDrawing& strokes)
    {
        for (const auto& stroke : strokes) {
            drawing.begin_stroke();
            for (const InputPoint point : stroke)
                if (!drawing.add(point))
                    return false;
        }
        return true;
    }
};

}

TEST_CASE("a drawing is empty at first, and shows the next one from show() on")
{
    Sheet sheet{2, 5};
    CHECK(received_drawing(sheet.drawing).empty());
    const ReceivedDrawing received{{{1, 2}, {3, 4}, {-32768, 32767}}, {{5, 6}}};
    CHECK(sheet.set(received));
    CHECK(received_drawing(sheet.drawing).empty());
    CHECK(sheet.drawing.show());
    CHECK(received_drawing(sheet.drawing) == received);
    CHECK(sheet.set({{{7, 8}}}));
    CHECK(received_drawing(sheet.drawing) == received);
    CHECK(sheet.drawing.show());
    CHECK(received_drawing(sheet.drawing) == ReceivedDrawing{{{7, 8}}});
    CHECK(sheet.drawing.show());
    CHECK(received_drawing(sheet.drawing).empty());
}

TEST_CASE("a drawing takes as many strokes and points as it may have, and no more")
{
    for (const auto& [strokes, points] : {std::pair{1U, 1U}, {1U, 7U}, {2U, 7U}, {3U, 3U}}) {
        Sheet sheet{strokes, points};
        for (int round = 0; round < 3; ++round) {
            for (std::uint32_t point = 0; point < points; ++point) {
                if (point < strokes)
                    sheet.drawing.begin_stroke();
                REQUIRE(sheet.drawing.add({static_cast<std::int16_t>(point), 0}));
            }
            CHECK_FALSE(sheet.drawing.add({}));
            sheet.drawing.show();
            CHECK(sheet.drawing.strokes() == strokes);
            CHECK(sheet.memory.back() == Sheet::guard);
        }
    }
    Sheet sheet{2, 9};
    CHECK_FALSE(sheet.set({{{1, 1}}, {{2, 2}}, {{3, 3}}}));
}

TEST_CASE("strokes without points are none, and begin() drops what has been told")
{
    Sheet sheet{2, 9};
    sheet.drawing.set_mark(9);
    CHECK(sheet.set({{}, {{1, 1}}, {}, {}, {{2, 2}}, {}}));
    CHECK(sheet.drawing.mark() == 9);
    sheet.drawing.show();
    CHECK(sheet.drawing.mark() == 0);
    CHECK(received_drawing(sheet.drawing) == ReceivedDrawing{{{1, 1}}, {{2, 2}}});
    CHECK(sheet.set({{{3, 3}}}));
    sheet.drawing.set_mark(9);
    sheet.drawing.begin();
    CHECK(sheet.drawing.mark() == 0);
    CHECK(sheet.set({{{4, 4}}}));
    sheet.drawing.show();
    CHECK(received_drawing(sheet.drawing) == ReceivedDrawing{{{4, 4}}});
}

TEST_CASE("show() tells whether anything differs")
{
    Sheet sheet{2, 4};
    CHECK_FALSE(sheet.drawing.show());
    const ReceivedDrawing drawings[]{{{{1, 2}, {3, 4}}}, {{{1, 2}, {3, 5}}},           {{{1, 2}}, {{3, 5}}},
                                     {{{1, 2}}},         {{{1, 2}}, {{3, 5}, {6, 7}}}, {}};
    for (const ReceivedDrawing& drawing : drawings) {
        CHECK(sheet.set(drawing));
        CHECK(sheet.drawing.show());
        CHECK(sheet.set(drawing));
        CHECK_FALSE(sheet.drawing.show());
        CHECK(received_drawing(sheet.drawing) == drawing);
    }
}

}
