#pragma once

#include <type_traits>

namespace kfast {

/// Ends the program if a caller breaks what a header asks of it: "only when", "at least", "within". That is a
/// bug of the caller, and no answer to it is of use.
///
/// - In programs that are compiled with KFAST_EXPECTS, as tests with sanitizers are, it traps.
/// - A constant expression that breaks it does not compile, wherever it stands.
/// - Elsewhere, as on a device, nothing is left of it. So a condition costs little, and does nothing.
///
/// Bytes from outside are never a reason: they are checked, and refused with an Error.
constexpr void expects(bool condition)
{
#ifdef KFAST_EXPECTS
    if (!condition)
        __builtin_trap();
#else
    if (std::is_constant_evaluated() && !condition)
        __builtin_trap();
#endif
}

}
