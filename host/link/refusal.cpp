#include "host/link/refusal.hpp"

#include "host/program/slow_scene.hpp"
#include "host/text/glyph.hpp"

#include <string>

namespace kfast {
namespace {

ExitStatus exit_status_of(Status status)
{
    switch (status) {
    case Status::no_room:
    case Status::too_large:
    case Status::block_too_small:
        return ExitStatus::no_room;
    case Status::unsupported_version:
    case Status::unknown_kind:
        return ExitStatus::wrong_version;
    case Status::timed_out:
        return ExitStatus::timed_out;
    default: // what devices to come may say as well
        return ExitStatus::refused;
    }
}

/// What would help; empty if nothing is known.
std::string hint_of(const link::Failure& failure)
{
    const std::string number = std::to_string(failure.number);
    switch (failure.status) {
    case Status::no_room:
        return "there is room for " + number + " bytes: erase a slot ('kfast erase'), or shorten the scene";
    case Status::too_large:
        return "it holds " + number + " bytes: upload it to a slot ('kfast upload'), or shorten the scene";
    case Status::block_too_small:
        return "'kfast fit' tells how much the scene needs; in RAM it lies in the same memory itself, so "
               "'kfast upload --play' may do";
    case Status::too_slow:
        return std::string{slow_scene_hint};
    case Status::unsupported_version:
    case Status::unknown_kind:
        return "update the firmware of the device, or use the kfast that belongs to it";
    case Status::bad_checksum:
        return "try again, with another cable if need be";
    case Status::no_transfer:
        return "if another program sends a scene as well, try again when it is done";
    case Status::timed_out:
        return "try again";
    case Status::no_such_slot:
        return "they go from 0 to " + std::to_string(failure.number == 0 ? 0 : failure.number - 1);
    case Status::empty_slot:
        return "'kfast slots' lists what there is";
    case Status::nothing_in_ram:
        return "send one with 'kfast play SCENE'";
    case Status::nothing_plays:
        return "play one with 'kfast play SCENE'";
    case Status::no_scene:
        return "'kfast upload SCENE --choose' brings one for the start, 'kfast uf2 pack --scene' a built-in "
               "one";
    case Status::no_laser:
        return "a beam is dangerous if its board's settings say laser=#true";
    case Status::no_such_clip:
        return "'kfast info SCENE' lists them";
    case Status::no_such_input:
        return "another scene plays by now: begin anew";
    default:
        return {};
    }
}

std::string in_words(const link::Failure& failure)
{
    const std::string text = visible(failure.text.view());
    const std::string said =
        text.empty() ? "error " + std::to_string(static_cast<unsigned>(failure.status)) : text;
    const std::string hint = hint_of(failure);
    return "the device says: " + said + (hint.empty() ? "" : ": " + hint);
}

}

Refusal::Refusal(const link::Failure& failure)
    : Failure{in_words(failure), exit_status_of(failure.status)}, status_{failure.status}, number_{
                                                                                               failure.number}
{
}

}
