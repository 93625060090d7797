#include "tests/fuzz/farewell.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <utility>

#ifndef __has_feature
#define __has_feature(feature) 0
#endif
#if __has_feature(address_sanitizer) || __has_feature(memory_sanitizer)
#include <sanitizer/common_interface_defs.h>
#define KFAST_HAS_SANITIZER
#endif

namespace kfast::test {
namespace {

/// Made before, as a signal allows no more than to write it.
std::string farewell;

void say_farewell()
{
    [[maybe_unused]] const auto written = write(STDERR_FILENO, farewell.data(), farewell.size());
    farewell.clear();
}

void end_by(int signal)
{
    say_farewell();
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

bool watch()
{
    for (const int signal : {SIGABRT, SIGILL, SIGTRAP, SIGFPE, SIGXCPU})
        std::signal(signal, end_by);
#ifdef KFAST_HAS_SANITIZER
    __sanitizer_set_death_callback(say_farewell);
#endif
    return true;
}

/// What keeps the processor for longer is as bad as what breaks something. Its own time counts, whatever else
/// is busy.
void allow_seconds(rlim_t seconds)
{
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    rlimit limit{};
    getrlimit(RLIMIT_CPU, &limit);
    limit.rlim_cur = static_cast<rlim_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) + seconds;
    setrlimit(RLIMIT_CPU, &limit);
}

}

void say_if_it_ends(std::string words)
{
    [[maybe_unused]] static const bool watches = watch();
    farewell = std::move(words);
    allow_seconds(60);
}

}
