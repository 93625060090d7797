#include "host/simulator/trace.hpp"

#include "host/program/failure.hpp"
#include "tests/bytes.hpp"
#include "tests/host/simulator/trace_bytes.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>

namespace kfast::test {
namespace {

std::string refusal(const std::vector<std::byte>& trace)
{
    try {
        read_trace(trace);
    } catch (const Failure& failure) {
        return failure.what();
    }
    return "none";
}

}

TEST_CASE("a trace is read record by record")
{
    TraceBytes trace;
    trace.add(TraceKind::command, 5, bytes({0x2A})).add(TraceKind::data, 6, bytes({1, 2}));
    trace.add(TraceKind::reset_low, 6).note(5'000'000'000, "hello");
    const auto records = read_trace(trace.bytes);
    REQUIRE(records.size() == 4);
    CHECK(records[0].kind == TraceKind::command);
    CHECK(records[0].time == std::chrono::microseconds{5});
    CHECK(std::ranges::equal(records[0].bytes, bytes({0x2A})));
    CHECK(records[0].position == 8);
    CHECK(records[1].kind == TraceKind::data);
    CHECK(std::ranges::equal(records[1].bytes, bytes({1, 2})));
    CHECK(records[1].position == 8 + 14);
    CHECK(records[2].kind == TraceKind::reset_low);
    CHECK(records[3].time == std::chrono::seconds{5000});
    CHECK(std::ranges::equal(records[3].bytes, bytes({'h', 'e', 'l', 'l', 'o'})));
    CHECK(read_trace(TraceBytes{}.bytes).empty());
}

TEST_CASE("a damaged trace is refused with the position")
{
    TraceBytes trace;
    trace.add(TraceKind::command, 5, bytes({0x2A}));
    SUBCASE("no trace")
    {
        CHECK(refusal(bytes({'K', 'F', 'T', 'R', 'A', 'C', 'E', '2'})) ==
              "the trace is damaged at byte 0: it does not begin with KFTRACE1");
        CHECK(refusal({}) == "the trace is damaged at byte 0: it does not begin with KFTRACE1");
    }
    SUBCASE("cut off in a head")
    {
        trace.add(TraceKind::data, 6);
        trace.bytes.pop_back();
        CHECK(refusal(trace.bytes) == "the trace is damaged at byte 22: it ends within the head of a record");
    }
    SUBCASE("cut off in the bytes")
    {
        trace.add(TraceKind::data, 6, bytes({1, 2, 3}));
        trace.bytes.pop_back();
        CHECK(refusal(trace.bytes) ==
              "the trace is damaged at byte 22: a record of 3 bytes, of which 2 are there");
    }
    SUBCASE("no such kind")
    {
        trace.add(7, 6000, 0, {});
        CHECK(refusal(trace.bytes) == "the trace is damaged at byte 22: there is no record of kind 7");
    }
    SUBCASE("time goes back")
    {
        trace.add(TraceKind::reset_low, 4);
        CHECK(refusal(trace.bytes) == "the trace is damaged at byte 22: the time goes back");
    }
    SUBCASE("no time")
    {
        trace.add(2, std::uint64_t{1} << 63, 0, {});
        CHECK(refusal(trace.bytes) == "the trace is damaged at byte 22: a time beyond all times");
    }
    SUBCASE("bytes where there are none")
    {
        trace.add(TraceKind::selected, 6, bytes({1}));
        CHECK(refusal(trace.bytes) ==
              "the trace is damaged at byte 22: a record of kind 4 has no bytes, this one 1");
    }
}

}
