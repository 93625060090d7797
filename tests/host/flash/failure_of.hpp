#pragma once

#include "host/program/failure.hpp"

#include <doctest/doctest.h>
#include <string>

namespace kfast::test {

/// What a Failure says that `action` must throw, and with that status.
inline std::string failure_of(const auto& action, ExitStatus status)
{
    try {
        action();
    } catch (const Failure& failure) {
        CHECK(failure.status() == status);
        return failure.what();
    }
    FAIL("nothing was thrown");
    return {};
}

}
