#pragma once

#include "core/bytes/result.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace kfast {

/// How something that a computer asked of a device went. The numbers go over the wire and stay what they are;
/// those below 16 are why a scene cannot be played (Error).
enum class Status : std::uint8_t {
    ok = 0,
    truncated = static_cast<std::uint8_t>(Error::truncated),
    bad_magic = static_cast<std::uint8_t>(Error::bad_magic),
    unsupported_version = static_cast<std::uint8_t>(Error::unsupported_version),
    bad_checksum = static_cast<std::uint8_t>(Error::bad_checksum), ///< also of an upload
    bad_scene = static_cast<std::uint8_t>(Error::bad_scene),
    block_too_small = static_cast<std::uint8_t>(Error::block_too_small),
    too_slow = static_cast<std::uint8_t>(Error::too_slow),
    bad_report = 16, ///< not 64 bytes, or damaged
    unknown_kind,    ///< nothing this firmware knows
    bad_value,       ///< a number in the report is out of its range
    no_such_slot,    ///< with the number of slots
    empty_slot,      ///< the slot holds no scene
    nothing_in_ram,  ///< no scene was sent there, or it was replaced
    nothing_plays,   ///< there is no scene that it could be about
    no_such_clip,    ///< the scene has none of that name
    no_such_input,   ///< with the number of inputs of what plays
    no_room,         ///< in the flash; with the bytes of the largest scene that there is room for
    too_large,       ///< for the RAM; with the bytes of the largest scene that it holds
    no_transfer,     ///< data or commit without an upload that they belong to
    incomplete,      ///< commit before all blocks have come; with the number of the next block
    timed_out,       ///< no block came for too long; the upload is over
    flash_failed,    ///< flash does not hold what was written to it
    unsupported,     ///< this board cannot do that
    no_drawing,      ///< the input takes something else
    drawing_broken,  ///< a report of it is missing, or came twice; the drawing before stays
    drawing_large,   ///< more strokes or points than the input takes; the drawing before stays
    no_text,         ///< likewise
    no_scene,        ///< nothing was ever written where the scene is to lie
    no_laser,        ///< there is nothing to arm
};

/// A later device may have more of them.
constexpr bool is_known(Status) { return true; }

constexpr Status status_of(Error error) { return static_cast<Status>(error); }

/// A status, and the number that goes with it.
struct StatusWithNumber {
    Status status = Status::ok;
    std::uint32_t number = 0;

    constexpr StatusWithNumber() = default;
    constexpr StatusWithNumber(Status code, std::uint32_t with = 0) : status{code}, number{with} {}

    constexpr bool is_ok() const { return status == Status::ok; }
    friend constexpr bool operator==(const StatusWithNumber&, const StatusWithNumber&) = default;
};

/// The longest text of a status.
inline constexpr std::size_t longest_status_text = 56;

/// "bad_magic: not a compiled scene" becomes "not a compiled scene".
constexpr std::string_view without_name(std::string_view text)
{
    const auto colon = std::ranges::find(text, ':');
    return {colon + 2, text.end()};
}

/// What a status means, for people, without its number; empty if it is none.
constexpr std::string_view status_text(Status status)
{
    using namespace std::string_view_literals; // of known length: nothing calls strlen
    switch (status) {
    case Status::ok:
        return "done"sv;
    case Status::truncated:
    case Status::bad_magic:
    case Status::unsupported_version:
    case Status::bad_checksum:
    case Status::bad_scene:
    case Status::block_too_small:
    case Status::too_slow:
        return without_name(error_text(static_cast<Error>(status)));
    case Status::bad_report:
        return "the report is cut short or damaged"sv;
    case Status::unknown_kind:
        return "the firmware does not know this kind of report"sv;
    case Status::bad_value:
        return "a number in the report is out of its range"sv;
    case Status::no_such_slot:
        return "there are not so many slots"sv;
    case Status::empty_slot:
        return "the slot holds no scene"sv;
    case Status::nothing_in_ram:
        return "no scene lies in RAM"sv;
    case Status::nothing_plays:
        return "no scene plays"sv;
    case Status::no_such_clip:
        return "the scene has no clip of that name"sv;
    case Status::no_such_input:
        return "the scene that plays has not so many inputs"sv;
    case Status::no_room:
        return "no free stretch of the flash is long enough"sv;
    case Status::too_large:
        return "the scene is larger than the RAM for it"sv;
    case Status::no_transfer:
        return "no upload is under way that this belongs to"sv;
    case Status::incomplete:
        return "not all blocks of the scene have come"sv;
    case Status::timed_out:
        return "no block came for too long: the upload is dropped"sv;
    case Status::flash_failed:
        return "flash does not hold what was written to it"sv;
    case Status::unsupported:
        return "this board cannot do that"sv;
    case Status::no_drawing:
        return "this input of the scene is no drawing"sv;
    case Status::drawing_broken:
        return "reports of the drawing are missing or repeated"sv;
    case Status::drawing_large:
        return "the drawing has more points than the input takes"sv;
    case Status::no_text:
        return "this input of the scene is no text"sv;
    case Status::no_scene:
        return "no scene lies there"sv;
    case Status::no_laser:
        return "this board leads no laser: nothing is to be armed"sv;
    }
    return ""sv;
}

}
