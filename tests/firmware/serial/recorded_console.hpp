#pragma once

#include <doctest/doctest.h>

#include <string>

namespace kfast::test {

/// Keeps what is told and answers with what has been put down as `typed`.
class RecordedConsole {
public:
    void write(char letter) { written += letter; }
    bool pending() const { return !typed.empty(); }
    char read()
    {
        REQUIRE(pending());
        const char letter = typed.front();
        typed.erase(0, 1);
        return letter;
    }

    std::string written;
    std::string typed;
};

}
