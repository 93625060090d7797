#include "host/player/received_drawing.hpp"
#include "tests/compiled.hpp"
#include "tests/firmware/link/link_bench.hpp"

#include <doctest/doctest.h>

#include <random>

/// Live drawings over the link.
namespace kfast::test {

using namespace link;

namespace {

constexpr std::string_view plots = R"(
kfast 1
canvas 60 40
input level
input plot kind=drawing points=200 strokes=3 { line 0 0 10 10 }
input other kind=drawing points=4000 strokes=2000
object a stroke=white live=plot
object b stroke=white live=other { track x input=level { at 0 0; at 1 9 } }
)";

/// A device that plays the scene from RAM.
struct PlotBench : LinkBench {
    PlotBench()
    {
        const Scene scene = compiled(plots);
        REQUIRE(upload(begin_for_ram(scene), scene, 7).is_ok());
        REQUIRE(does(Play{.home = Home::ram}));
    }

    void send(const std::vector<Report>& reports)
    {
        for (const Report& report : reports)
            link.take(report.bytes, now);
    }
    using LinkBench::send;
};

ReceivedDrawing some_drawing(std::size_t strokes, std::size_t points, unsigned seed)
{
    std::mt19937 random{seed};
    ReceivedDrawing drawing(strokes);
    for (std::size_t i = 0; i < points; ++i) {
        const auto coordinate = [&] { return static_cast<std::int16_t>(random() % 65535 - 32767); };
        const std::int16_t x = coordinate();
        drawing[i % strokes].push_back({x, coordinate()});
    }
    return drawing;
}

const ReceivedDrawing default_value{{{0, 0}, {160, 160}}};

}

TEST_CASE("a drawing comes in as many reports as its points need, and in no more")
{
    const auto reports = [](std::size_t strokes, std::size_t points) {
        return drawing_reports(some_drawing(strokes, points, 1), 1, 0).size();
    };
    CHECK(reports(1, 14) == 1);
    CHECK(reports(1, 15) == 2);
    CHECK(reports(1, 29) == 2);
    CHECK(reports(1, 30) == 3);
    CHECK(reports(2, 29) == 3); // a pen that is lifted takes the place of a point
    CHECK(reports(1, 200) == 14);
    CHECK(drawing_reports({}, 1, 0).size() == 1);
    for (const std::size_t count : {0U, 1U, 14U, 15U, 29U, 30U, 200U, 4000U})
        CHECK(reports_of_drawing(count) == drawing_reports(some_drawing(1, count, 1), 1, 0).size());
}

TEST_CASE("a drawing is shown when its last report has come, without a word in return")
{
    PlotBench bench;
    CHECK(bench.device.drawing(1) == default_value);
    std::uint8_t number = 0;
    for (const std::size_t points : {200U, 3U, 15U, 14U, 29U, 30U, 199U, 1U}) {
        const ReceivedDrawing drawing = some_drawing(points == 199 ? 3 : 1, points, 2);
        const ReceivedDrawing before = bench.device.drawing(1);
        auto reports = drawing_reports(drawing, 1, number++);
        const Report last = reports.back();
        reports.pop_back();
        bench.send(reports);
        CHECK(bench.device.drawing(1) == before);
        bench.send({last});
        CHECK(bench.device.drawing(1) == drawing);
    }
    bench.send(drawing_reports({}, 1, number));
    CHECK(bench.device.drawing(1).empty());
    CHECK_FALSE(bench.link.has_report());
}

TEST_CASE("drawings of several inputs may come at once, also such with more than 256 reports")
{
    PlotBench bench;
    const ReceivedDrawing small = some_drawing(3, 60, 3);
    const ReceivedDrawing large = some_drawing(2000, 4000, 4);
    const auto of_small = drawing_reports(small, 1, 5);
    const auto of_large = drawing_reports(large, 2, 5);
    REQUIRE(of_large.size() > 256);
    for (std::size_t i = 0; i < of_large.size(); ++i) {
        bench.send({of_large[i]});
        if (i < of_small.size())
            bench.send({of_small[i]});
    }
    CHECK(bench.device.drawing(1) == small);
    CHECK(bench.device.drawing(2) == large);
    CHECK_FALSE(bench.link.has_report());
}

TEST_CASE(
    "a drawing with a report that is lost, repeated or out of its order is dropped, and that is told once")
{
    const ReceivedDrawing drawing = some_drawing(1, 70, 5); // in five reports
    const auto whole = drawing_reports(drawing, 1, 1);
    REQUIRE(whole.size() == 5);
    for (std::size_t at = 0; at + 1 < whole.size(); ++at)
        for (int mishap = 0; mishap < 3; ++mishap) {
            CAPTURE(at);
            CAPTURE(mishap);
            PlotBench bench;
            auto reports = whole;
            const auto place = reports.begin() + static_cast<std::ptrdiff_t>(at);
            if (mishap == 0)
                reports.erase(place);
            else if (mishap == 1 && at != 0)
                reports.insert(place, *place);
            else
                std::iter_swap(place, place + 1);
            bench.send(reports);
            CHECK(bench.device.drawing(1) == default_value);
            CHECK(bench.last_failure().status == Status::drawing_broken);
            CHECK_FALSE(bench.link.has_report());
            bench.send(drawing_reports(drawing, 1, 2));
            CHECK(bench.device.drawing(1) == drawing);
        }
}

TEST_CASE("parts of different drawings are not put together")
{
    PlotBench bench;
    const auto first = drawing_reports(some_drawing(1, 70, 6), 1, 1);
    const auto second = drawing_reports(some_drawing(1, 70, 7), 1, 2);
    bench.send({first[0], first[1], second[2], second[3], second[4]});
    CHECK(bench.device.drawing(1) == default_value);
    bench.send({first[0], first[1], first[2]});
    bench.send(second); // begins anew
    CHECK(bench.device.drawing(1) == some_drawing(1, 70, 7));
}

TEST_CASE("a drawing that was begun in a scene is not ended in another one")
{
    PlotBench bench;
    const auto reports = drawing_reports(some_drawing(1, 70, 8), 1, 1);
    bench.send({reports[0], reports[1], reports[2]});
    REQUIRE(bench.does(Play{.home = Home::here}));
    bench.send({reports[3], reports[4]});
    CHECK(bench.device.drawing(1) == default_value);
}

TEST_CASE("what an input does not take is refused, and what it shows stays")
{
    PlotBench bench;
    bench.send(drawing_reports(some_drawing(1, 201, 9), 1, 1));
    CHECK(bench.last_failure().status == Status::drawing_large);
    bench.send(drawing_reports(some_drawing(4, 8, 9), 1, 1));
    CHECK(bench.last_failure().status == Status::drawing_large);
    CHECK(bench.device.drawing(1) == default_value);
    bench.send(drawing_reports({}, 0, 1));
    CHECK(bench.last_failure() == StatusWithNumber{Status::no_drawing});
    bench.send(drawing_reports({}, 3, 1));
    CHECK(bench.last_failure() == StatusWithNumber{Status::no_such_input, 3});
    CHECK(bench.refusal(Drawing{.which = 1, .part = 0, .count = 15}) ==
          StatusWithNumber{Status::drawing_broken});
    bench.send({drawing_reports(some_drawing(1, 70, 9), 1, 0).front()});
    CHECK(bench.refusal(Drawing{.which = 1, .part = 1, .count = 14}) == // fewer than have come
          StatusWithNumber{Status::drawing_broken});
    CHECK(bench.does(Drawing{.which = 1, .part = 0, .count = 14}));
    CHECK(bench.does(Points{.which = 1, .part = 0}));
}

TEST_CASE("whatever gets lost on the way, only whole drawings are shown")
{
    PlotBench bench;
    std::mt19937 random{10};
    std::vector<ReceivedDrawing> sent{default_value};
    std::size_t shown = 0;
    for (unsigned frame = 0; frame < 400; ++frame) {
        sent.push_back(some_drawing(1 + frame % 3, 3 + random() % 190, frame));
        for (const Report& report : drawing_reports(sent.back(), 1, static_cast<std::uint8_t>(frame)))
            for (auto times = random() % 30 == 0 ? random() % 3 : 1U; times > 0; --times)
                bench.send({report});
        const ReceivedDrawing now = bench.device.drawing(1);
        const auto which = std::ranges::find(sent, now);
        REQUIRE(which != sent.end());
        const auto place = static_cast<std::size_t>(which - sent.begin());
        CHECK(place >= shown);
        shown = place;
        bench.last_failure();
    }
    CHECK(shown > 350);
}

}
