#include "core/bytes/expects.hpp"
#include "core/bytes/result.hpp"
#include "core/math/fixed.hpp"
#include "core/raster/slots.hpp"

#include <doctest/doctest.h>

#include <csignal>
#include <sys/wait.h>
#include <type_traits>
#include <unistd.h>

namespace kfast {
namespace {

template <auto* function>
concept Constant = requires
{
    typename std::bool_constant<(function(), true)>;
};

constexpr void kept() { expects(true); }
constexpr void broken() { expects(false); }

constexpr int value_of(const Result<int>& result) { return *result; }
constexpr void read_value() { static_cast<void>(value_of(7)); }
constexpr void read_value_of_an_error() { static_cast<void>(value_of(Error::truncated)); }
constexpr void read_error_of_a_value() { static_cast<void>(Result<int>{7}.error()); }

constexpr void divide_by_zero() { static_cast<void>(quotient(std::uint64_t{1}, 0)); }
constexpr void take_more_than_all() { static_cast<void>(Fraction::ratio(3, 2)); }
constexpr void number_no_bit() { static_cast<void>(raster::number_of(0)); }

// A constant expression that breaks a contract does not compile.
static_assert(Constant<kept> && !Constant<broken>);
static_assert(Constant<read_value> && !Constant<read_value_of_an_error> && !Constant<read_error_of_a_value>);
static_assert(!Constant<divide_by_zero> && !Constant<take_more_than_all>);
static_assert(!Constant<number_no_bit>);

/// Whether a process comes to the end of `run`.
template <class Run>
bool survives(Run run)
{
    const pid_t child = ::fork();
    if (child == 0) {
        std::signal(SIGILL, SIG_DFL);
        std::signal(SIGTRAP, SIG_DFL);
        run();
        ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}

TEST_CASE("a broken contract ends a program that is compiled to notice")
{
#ifdef KFAST_EXPECTS
    constexpr bool is_noticed = true;
#else
    constexpr bool is_noticed = false;
#endif
    CHECK(survives([] { kept(); }));
    CHECK(survives([] { broken(); }) == !is_noticed);
}

}
