#pragma once

#include "firmware/link/fields.hpp"
#include "firmware/link/message.hpp"
#include "firmware/status.hpp"

#include <cstdint>

namespace kfast::link {

/// The result of a request: its answer, or why there is none.
template <Answer A>
struct Outcome {
    StatusWithNumber result;
    A answer{};
    bool is_put_off = false; ///< it is to be tried once more, soon

    constexpr Outcome(const A& given) : answer{given} {}
    constexpr Outcome(StatusWithNumber why) : result{why} {}
    constexpr Outcome(Status status) : result{status} {}

    static constexpr Outcome put_off()
    {
        Outcome outcome{StatusWithNumber{}};
        outcome.is_put_off = true;
        return outcome;
    }
};

/// The result of a request whose answer is only whether it was carried out.
template <Kind kind>
using Completion = Outcome<Done<kind>>;

inline Failure failure(std::uint8_t request, StatusWithNumber result)
{
    return {.request = request,
            .status = result.status,
            .number = result.number,
            .text = {status_text(result.status)}};
}

}
