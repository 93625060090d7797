#pragma once

#include "firmware/chip/stored_text.hpp"

#include <cstdint>

namespace kfast::link {

/// Is increased when a computer or a device that knows the previous number cannot understand what is meant.
inline constexpr std::uint8_t protocol_version = 2;

/// Byte 0 of a report. The answer to a request has the same number and `from_device`.
enum class Kind : std::uint8_t {
    hello = 0x01,
    names = 0x02,
    playing = 0x03,
    statistics = 0x04,
    input = 0x05,
    begin = 0x10,
    data = 0x11,
    commit = 0x12,
    cancel = 0x13,
    slot = 0x20,
    erase = 0x21,
    choose = 0x22,
    play = 0x30,
    pause = 0x31,
    resume = 0x32,
    seek = 0x33,
    speed = 0x34,
    brightness = 0x35,
    inputs = 0x36,
    text = 0x37,
    points = 0x38,
    drawing = 0x39,
    silence = 0x3A,
    arm = 0x3B,
    disarm = 0x3C,
    boot_loader = 0x3F,
    error = 0x7F, ///< only from the device
};

/// Whether requests of that kind and their answers end with a checksum (checksum.hpp): those that change what
/// lies in slots and in RAM, those that tell what a slot holds, by which a computer chooses one, and those
/// that are dangerous when nobody has asked for them, or when a laser relies on them.
constexpr bool has_checksum(Kind kind)
{
    switch (kind) {
    case Kind::begin:
    case Kind::commit:
    case Kind::cancel:
    case Kind::slot:
    case Kind::erase:
    case Kind::choose:
    case Kind::play:
    case Kind::silence:
    case Kind::arm:
    case Kind::boot_loader:
        return true;
    case Kind::hello:
    case Kind::names:
    case Kind::playing:
    case Kind::statistics:
    case Kind::input:
    case Kind::data: // has that of the whole scene
    case Kind::pause:
    case Kind::resume:
    case Kind::seek:
    case Kind::speed:
    case Kind::brightness:
    case Kind::inputs:
    case Kind::text:
    case Kind::points:
    case Kind::drawing:
    case Kind::disarm:
    case Kind::error:
        break;
    }
    return false;
}

/// Names of scenes and clips.
using Name = StoredText<24>;

/// Where a scene is.
enum class Home : std::uint8_t {
    built_in, ///< where a UF2 file puts it
    slot,
    ram,
    here,  ///< only in Play: where what plays now is
    start, ///< only in Play: what plays when the device starts
};
constexpr bool is_known(Home home) { return home <= Home::start; }

/// Represents a missing slot.
inline constexpr std::uint8_t no_slot = 0xFF;

/// A request that has only its kind.
template <Kind which>
struct Plain {
    static constexpr Kind kind = which;
    static constexpr void fields(auto&&, auto&) {}
};

/// An answer that says only that the request was carried out.
template <Kind which>
struct Done : Plain<which> {
    static constexpr bool answers = true;
};

}
