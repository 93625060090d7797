#include "host/program/interruption.hpp"

#include <array>
#include <atomic>
#include <csignal>

namespace kfast {
namespace {

constexpr std::array signals{SIGHUP, SIGINT, SIGTERM};

std::atomic<bool> interrupted = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a handler may touch nothing else");

extern "C" void remember(int number)
{
    std::signal(number, SIG_DFL);
    interrupted = true;
}

/// What is ignored stays so: nohup and shells ask for it.
void set_handler(void (*handler)(int))
{
    for (const int number : signals) {
        struct sigaction action = {};
        ::sigaction(number, nullptr, &action);
        if (action.sa_handler == SIG_IGN)
            continue;
        action = {};
        action.sa_handler = handler; // without SA_RESTART: a waiting call is to notice
        ::sigaction(number, &action, nullptr);
    }
}

}

RememberedInterruption::RememberedInterruption()
{
    interrupted = false;
    set_handler(remember);
}

RememberedInterruption::~RememberedInterruption()
{
    set_handler(SIG_DFL);
    interrupted = false;
}

bool was_interrupted() { return interrupted; }

void heed_interruption()
{
    if (was_interrupted())
        throw Interrupted{};
}

}
