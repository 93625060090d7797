#pragma once

#include "firmware/link/fields.hpp"
#include "firmware/link/message.hpp"
#include "firmware/status.hpp"

#include <cstdint>

namespace kfast::link {

/// What comes of a request: its answer, or why there is none.
template <Answer A>
struct Outcome {
    Verdict verdict;
    A answer{};
    bool is_put_off = false; ///< it is to be asked for once more, soon

    constexpr Outcome(const A& given) : answer{given} {}
    constexpr Outcome(Verdict why) : verdict{why} {}
    constexpr Outcome(Status status) : verdict{status} {}

    static constexpr Outcome put_off()
    {
        Outcome outcome{Verdict{}};
        outcome.is_put_off = true;
        return outcome;
    }
};

/// Of a request that is answered by nothing but that it was done, or was not.
template <Kind kind>
using Deed = Outcome<Done<kind>>;

inline Failure failure(std::uint8_t request, Verdict verdict)
{
    return {.request = request,
            .status = verdict.status,
            .number = verdict.number,
            .text = {status_text(verdict.status)}};
}

}
