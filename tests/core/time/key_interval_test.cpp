#include "core/time/track.hpp"

#include <doctest/doctest.h>
#include <utility>
#include <vector>

namespace kfast::test {
namespace {

struct Moment {
    Time time;
};

/// Keys in memory.
class Moments {
public:
    explicit Moments(const std::vector<Moment>& keys) : keys_{&keys} {}

    bool at_end() const { return next_ == keys_->size(); }
    Moment next() { return (*keys_)[next_++]; }

private:
    const std::vector<Moment>* keys_;
    std::size_t next_ = 0;
};

std::pair<int, int> around(const std::vector<Moment>& keys, int ticks)
{
    const auto [from, to] = interval_at(Moments{keys}, {ticks});
    return {from.time.ticks, to.time.ticks};
}

using Ticks = std::pair<int, int>;

/// From 0 to `length`, both axes by `law`.
ProgressXY progress_at(Time time, Time length, const VelocityLaw& law)
{
    return progress_between({}, length, time, {law, law}, nullptr);
}

}

TEST_CASE("an interval begins on its first key and ends before its second")
{
    const std::vector<Moment> keys{{{10}}, {{20}}, {{21}}, {{40}}};
    CHECK(around(keys, 10) == Ticks{10, 20});
    CHECK(around(keys, 19) == Ticks{10, 20});
    CHECK(around(keys, 20) == Ticks{20, 21});
    CHECK(around(keys, 21) == Ticks{21, 40});
    CHECK(around(keys, 39) == Ticks{21, 40});
}

TEST_CASE("before the first key and from the last one on there is the same key twice")
{
    const std::vector<Moment> keys{{{10}}, {{20}}, {{40}}};
    CHECK(around(keys, 9) == Ticks{10, 10});
    CHECK(around(keys, -1000) == Ticks{10, 10});
    CHECK(around(keys, 40) == Ticks{40, 40});
    CHECK(around(keys, 1000) == Ticks{40, 40});
    CHECK(around({{{10}}}, 9) == Ticks{10, 10});
    CHECK(around({{{10}}}, 10) == Ticks{10, 10});
    CHECK(around({{{10}}}, 11) == Ticks{10, 10});
}

TEST_CASE("x and y go by their own laws")
{
    const auto at = [](Time time) {
        return progress_between(Time::frame(10), Time::frame(20), time,
                                {VelocityLaw::decelerate, VelocityLaw::in_steps(5)}, nullptr);
    };
    CHECK(at(Time::frame(15)).x.raw == 46341);
    CHECK(at(Time::frame(15)).y.raw == 26214);
    CHECK(at(Time::frame(10)).x.raw == 0);
    CHECK(at(Time::frame(9)).y.raw == 0);
}

TEST_CASE("where there is no way, nothing of it has been gone")
{
    const LawPair even{};
    CHECK(progress_between({5}, {5}, {5}, even, nullptr).x == Progress{});
    CHECK(progress_between({5}, {5}, {7}, even, nullptr).x == Progress{});
    CHECK(progress_between({5}, {5}, {3}, even, nullptr).y == Progress{});
    CHECK(progress_between({0}, {2}, {1}, even, nullptr).y == Progress{Progress::one / 2});
}

TEST_CASE("steps come at their frames, though the share of the time is rounded")
{
    const VelocityLaw thirds = VelocityLaw::in_steps(3);
    const Time end = Time::frame(30);
    CHECK(progress_at({10 * 1024 - 1}, end, thirds).x.raw == 0);
    CHECK(progress_at(Time::frame(10), end, thirds).x.raw == 21845);
    CHECK(progress_at({20 * 1024 - 1}, end, thirds).x.raw == 21845);
    CHECK(progress_at(Time::frame(20), end, thirds).x.raw == 43691);
}

TEST_CASE("a hold of any length lasts to the last tick before the next key")
{
    for (const int frames : {1, 100, 200, 1'000'000}) {
        const Time end = Time::frame(frames);
        CHECK(progress_at({end.ticks - 1}, end, VelocityLaw::hold).x.raw == 0);
        CHECK(progress_at({end.ticks - 1}, end, VelocityLaw::hold).y.raw == 0);
    }
}

}
