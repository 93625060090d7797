#include "tests/emulation/linux/wires.hpp"

#include "tests/emulation/linux/real_calls.hpp"
#include "tests/emulation/linux/stand_in_root.hpp"

#include <algorithm>
#include <csignal>
#include <cstdlib>

namespace kfast::test {
namespace {

std::int64_t now = 1'000'000'000;
int sleeps = 0;

struct Signal {
    int number = 0;
    int sleep = 0; ///< 1: the first

    friend bool operator==(const Signal&, const Signal&) = default;
};

Signal wanted_signal()
{
    const auto words = described(stand_in_root() + "/signal");
    if (words.empty())
        return {};
    return {std::atoi(words.begin()->first.c_str()), std::atoi(words.begin()->second.c_str())};
}

std::int64_t stopped_in_this_sleep()
{
    constexpr std::int64_t nanoseconds = 1'000'000'000;
    static int sleep = 0;
    return number_of(described(stand_in_root() + "/stopped"), std::to_string(++sleep), 0) * nanoseconds;
}

/// Whether it is the sleep that the file asks for; sleeps are counted anew when it asks for another one.
bool is_time_for(const Signal& signal)
{
    static Signal last;
    sleeps = signal == last ? sleeps + 1 : 1;
    last = signal;
    return sleeps == signal.sleep;
}

}

std::int64_t stand_in_time() { return now; }

void pass_time(std::int64_t nanoseconds) { now += nanoseconds; }

bool sleep_until(std::int64_t moment)
{
    const Signal signal = wanted_signal();
    if (is_time_for(signal)) {
        write_wires("signal " + std::to_string(signal.number));
        std::raise(signal.number);
        return false;
    }
    now = std::max(now, moment) + stopped_in_this_sleep();
    write_wires("slept");
    return true;
}

void write_wires(const std::string& what)
{
    static std::FILE* const file = [] {
        std::FILE* const opened = real_fopen((stand_in_root() + "/wires").c_str(), "a");
        if (opened != nullptr)
            ::setlinebuf(opened); // tests read it meanwhile
        return opened;
    }();
    if (file != nullptr)
        std::fprintf(file, "%lld %s\n", static_cast<long long>(now), what.c_str());
}

}
