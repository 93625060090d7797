#include "firmware/run/tearing_wait.hpp"

#include <doctest/doctest.h>

namespace kfast::test {
namespace {

/// A TE line with an edge every `period` µs while it is wired; looking at it takes a microsecond.
struct Line {
    std::uint32_t period = 16'667;
    bool wired = true;
    std::uint32_t time = 0;

    std::uint32_t edges() const { return wired ? time / period : 0; }

    /// How long the wait took.
    std::uint32_t wait(TearingWait& tearing)
    {
        const std::uint32_t before = time;
        tearing.wait([this] { return edges(); }, [this] { return Microseconds{time += 1}; });
        return time - before;
    }
};

}

TEST_CASE("sending begins with the next edge")
{
    Line line;
    TearingWait tearing;
    line.time = 10'000;
    line.wait(tearing);
    CHECK(line.time == 16'667);
    line.time = 20'000;
    line.wait(tearing);
    CHECK(line.time == 2 * 16'667);
}

TEST_CASE("a line that stays silent is waited for once")
{
    Line line{.wired = false};
    TearingWait tearing;
    CHECK(line.wait(tearing) >= TearingWait::patience.count);
    CHECK(line.wait(tearing) == 0);
    CHECK(line.wait(tearing) == 0);
}

TEST_CASE("a line that is heard again is waited for again")
{
    Line line{.wired = false};
    TearingWait tearing;
    line.wait(tearing);
    line.wired = true;
    line.time = 100'000;
    line.wait(tearing);
    CHECK(line.time == 6 * 16'667);
}

}
