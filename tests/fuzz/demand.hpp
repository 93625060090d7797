#pragma once

#include <cstdlib>

namespace kfast {

/// Ends the program, which is a finding of the fuzzer, unless the condition holds.
inline void demand(bool condition)
{
    if (!condition)
        std::abort();
}

}
