#include "host/simulator/trace.hpp"

#include "host/program/failure.hpp"
#include "tests/host/simulator/trace_bytes.hpp"
#include "tests/host/simulator/wired_model.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

struct Replayed {
    std::unique_ptr<ControllerModel> model =
        make_controller_model(facts_of(Controller::ssd0323).default_value);
    std::vector<std::string> notes; ///< with the upper left level of the picture at that time
    std::string failure = "none";

    explicit Replayed(const TraceBytes& trace)
    {
        try {
            TraceReplay{*model}.play(read_trace(trace.bytes), [this](std::string_view note) {
                const auto level = pixel_of<PixelFormat::grey4>(model->picture(), 0, 0);
                notes.push_back(std::string{note} + " " + std::to_string(level));
            });
        } catch (const Failure& thrown) {
            failure = thrown.what();
        }
    }
};

TraceBytes& draw(TraceBytes& trace, std::uint64_t time, int pixels)
{
    trace.add(TraceKind::command, time,
              bytes({0xA8, 63, 0xA2, 0x40, 0xA0, 0x52, 0xAF, 0x15, 0, 0, 0x75, 0, 0}));
    return trace.add(TraceKind::data, time, bytes({pixels}));
}

}

TEST_CASE("a replay tells each note when all that came before it is on the glass")
{
    TraceBytes trace;
    draw(trace.note(1, "a"), 2, 0x70).note(3, "b");
    const Replayed replayed{draw(trace, 4, 0x90).note(5, "c")};
    CHECK(replayed.failure == "none");
    CHECK(replayed.notes == std::vector<std::string>{"a 0", "b 7", "c 9"});
}

TEST_CASE("the reset line resets the model when it rises")
{
    TraceBytes trace;
    draw(trace.add(TraceKind::reset_high, 0), 2, 0x70).note(3, "drawn");
    trace.add(TraceKind::reset_low, 10).add(TraceKind::reset_low, 15);
    SUBCASE("after 10 microseconds")
    {
        const Replayed replayed{trace.add(TraceKind::reset_high, 20).note(21, "reset")};
        CHECK(replayed.failure == "none");
        CHECK(replayed.notes == std::vector<std::string>{"drawn 7", "reset 0"});
    }
    SUBCASE("but not sooner")
    {
        CHECK(Replayed{trace.add(TraceKind::reset_high, 19)}.failure ==
              "the record at byte 105 of the trace, 19000 ns: a reset shorter than 10 microseconds");
    }
    SUBCASE("and nothing is heard before")
    {
        CHECK(Replayed{trace.add(TraceKind::command, 30, bytes({0xAE}))}.failure ==
              "the record at byte 105 of the trace, 30000 ns: bytes while the reset line is low");
    }
}

TEST_CASE("chip select counts in traces that tell of it")
{
    TraceBytes trace;
    SUBCASE("before it is active")
    {
        trace.add(TraceKind::command, 1, bytes({0xAE})).add(TraceKind::selected, 2);
        CHECK(Replayed{trace}.failure ==
              "the record at byte 8 of the trace, 1000 ns: bytes while chip select is inactive");
    }
    SUBCASE("while it is active")
    {
        draw(trace.add(TraceKind::selected, 1), 2, 0x70).add(TraceKind::deselected, 3).note(4, "drawn");
        CHECK(Replayed{trace}.notes == std::vector<std::string>{"drawn 7"});
    }
    SUBCASE("after it was")
    {
        draw(trace.add(TraceKind::selected, 1), 2, 0x70).add(TraceKind::deselected, 3);
        CHECK(Replayed{trace.add(TraceKind::data, 4, bytes({0}))}.failure.ends_with(
            "4000 ns: bytes while chip select is inactive"));
    }
}

TEST_CASE("a replay ends at the first mistake of the bus")
{
    TraceBytes trace;
    trace.add(TraceKind::command, 1500, bytes({0xAE, 0x23})).note(1600, "after it");
    const Replayed replayed{trace};
    CHECK(replayed.failure == "the record at byte 8 of the trace, 1500000 ns: the panel was driven wrongly: "
                              "byte 1 at 1.500 ms: unknown command 0x23");
    CHECK(replayed.notes.empty());
}

}
