#pragma once

#include <cstdint>
#include <string>

namespace kfast::test {

/// Nanoseconds that only sleeping and slow devices let pass, so that nothing depends on how fast this
/// computer is.
std::int64_t stand_in_time();
void pass_time(std::int64_t nanoseconds);

/// Sleeps until then. False if a signal came instead: the file `signal` below the root says "2 5" to get
/// SIGINT in the fifth sleep. `stopped` says "5 2400" for a program that is stopped for 2400 s in it.
bool sleep_until(std::int64_t moment);

/// Writes a line, with the time before it, into the file `wires` below the root.
void write_wires(const std::string& what);

}
