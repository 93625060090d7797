#pragma once

#include <cstdlib>

namespace kfast {

/// Ends the program, which is a finding of a fuzzer and a failure of a test, unless the condition holds.
inline void demand(bool condition)
{
    if (!condition)
        std::abort();
}

}
