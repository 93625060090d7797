#pragma once

#include "host/program/failure.hpp"

namespace kfast {

/// Ctrl-C while a device is at work.
class Interrupted : public Failure {
public:
    Interrupted() : Failure{"interrupted", ExitStatus::interrupted} {}
};

/// While it lives, the first SIGINT, SIGTERM or SIGHUP is only remembered, so that a device can be left in
/// order; the second ends the program. One at a time.
class RememberedInterruption {
public:
    RememberedInterruption();
    ~RememberedInterruption();
    RememberedInterruption(const RememberedInterruption&) = delete;
    RememberedInterruption& operator=(const RememberedInterruption&) = delete;
};

/// Whether there was one in the life of the RememberedInterruption.
bool was_interrupted();

/// Throws Interrupted if there was one.
void heed_interruption();

}
