#pragma once

#include "core/math/point.hpp"
#include "core/time/time.hpp"
#include "firmware/chip/stored_text.hpp"
#include "firmware/link/message_kind.hpp"
#include "firmware/link/restarts.hpp"
#include "firmware/status.hpp"

#include <cstdint>

/// What the reports of the link mean (docs/link.md). Each message is a struct whose fields() names its fields
/// in the order of their bytes, for writing and reading (fields.hpp). Those of uploads (upload_message.hpp)
/// and of inputs (input_message.hpp) are apart.
namespace kfast::link {

using Hello = Plain<Kind::hello>;
using AskNames = Plain<Kind::names>;
using AskPlaying = Plain<Kind::playing>;
using AskStatistics = Plain<Kind::statistics>;
using Pause = Plain<Kind::pause>;
using Resume = Plain<Kind::resume>;
using Arm = Plain<Kind::arm>;
using Disarm = Plain<Kind::disarm>;
using EnterBootLoader = Plain<Kind::boot_loader>;

/// What the device is.
struct Capabilities {
    static constexpr Kind kind = Kind::hello;
    static constexpr bool answers = true;
    std::uint8_t protocol = protocol_version;
    std::uint8_t slots = 0;
    Size panel{};
    std::uint32_t block_bytes = 0; ///< lent to the player
    std::uint32_t ram_bytes = 0;   ///< of the largest scene for RAM
    std::uint32_t pool_bytes = 0;  ///< flash of all slots together
    std::uint32_t room_bytes = 0;  ///< of the largest scene that a slot can take now
    StoredText<24> serial{};       ///< unique to the chip

    static constexpr void fields(auto&& io, auto& it)
    {
        io(it.protocol, it.slots, it.panel, it.block_bytes, it.ram_bytes, it.pool_bytes, it.room_bytes,
           it.serial);
    }
};

struct Names {
    static constexpr Kind kind = Kind::names;
    static constexpr bool answers = true;
    StoredText<14> firmware{}; ///< its version
    StoredText<24> board{};
    StoredText<24> panel{};

    static constexpr void fields(auto&& io, auto& it) { io(it.firmware, it.board, it.panel); }
};

/// Whether a dangerous beam may shine.
enum class Arming : std::uint8_t {
    none, ///< there is no dangerous beam
    disarmed,
    armed,
};
/// A later device may have more of them.
constexpr bool is_known(Arming) { return true; }

/// What plays now.
struct Playing {
    static constexpr Kind kind = Kind::playing;
    static constexpr bool answers = true;
    bool is_playing = false; ///< otherwise there is no scene that can be played, and the rest is empty
    bool is_paused = false;
    Home home = Home::built_in;
    std::uint8_t slot = no_slot;
    std::uint8_t brightness = 0;
    std::uint8_t inputs = 0; ///< how many the scene has
    Size canvas{};
    std::uint32_t frame_rate = 0; ///< in frames per 1000 seconds
    Time length{};                ///< of the scene
    Time moment{};                ///< the current time of playing
    std::int32_t speed = 0;       ///< Q16 of the authored one
    Name clip{};                  ///< empty: the whole scene
    Arming arming = Arming::none; ///< also if nothing plays
    Restarts restarts{};          ///< also if nothing plays; none from devices without a watchdog

    static constexpr void fields(auto&& io, auto& it)
    {
        io(it.is_playing, it.is_paused, it.home, it.slot, it.brightness, it.inputs, it.canvas, it.frame_rate,
           it.length, it.moment, it.speed, it.clip, it.arming, it.restarts);
    }
};

/// Counts since the device started; they wrap.
struct Statistics {
    static constexpr Kind kind = Kind::statistics;
    static constexpr bool answers = true;
    std::uint32_t frames = 0;      ///< shown
    std::uint32_t late = 0;        ///< of these, shown after they were due
    std::uint32_t skipped = 0;     ///< left out, because their time had passed
    std::uint32_t link_errors = 0; ///< reports that could not be understood, or had no room for their answer
    std::uint32_t coarse = 0;      ///< of the frames, drawn coarser or not completely, for want of room

    static constexpr void fields(auto&& io, auto& it)
    {
        io(it.frames, it.late, it.skipped, it.link_errors, it.coarse);
    }
};

/// A request about one slot: what it holds, erase it, or play it when the device starts.
template <Kind which>
struct OfSlot {
    static constexpr Kind kind = which;
    std::uint8_t slot = no_slot;

    static constexpr void fields(auto&& io, auto& it) { io(it.slot); }
};
using AskSlot = OfSlot<Kind::slot>;
using EraseSlot = OfSlot<Kind::erase>;
using ChooseSlot = OfSlot<Kind::choose>; ///< no_slot: the built-in scene

struct SlotContents {
    static constexpr Kind kind = Kind::slot;
    static constexpr bool answers = true;
    std::uint8_t slot = no_slot;
    bool is_chosen = false;
    std::uint32_t size = 0; ///< 0: empty
    std::uint32_t crc = 0;
    Name name{};

    static constexpr void fields(auto&& io, auto& it) { io(it.slot, it.is_chosen, it.size, it.crc, it.name); }
};

/// Plays from the beginning, as authored.
struct Play {
    static constexpr Kind kind = Kind::play;
    Home home = Home::here;
    std::uint8_t slot = no_slot; ///< only for Home::slot
    Name clip{};                 ///< empty: the whole scene

    static constexpr void fields(auto&& io, auto& it) { io(it.home, it.slot, it.clip); }
};

struct Seek {
    static constexpr Kind kind = Kind::seek;
    Time moment{}; ///< of the scene

    static constexpr void fields(auto&& io, auto& it) { io(it.moment); }
};

struct Speed {
    static constexpr Kind kind = Kind::speed;
    std::int32_t speed = 0; ///< Q16 of the authored one, within ±Playhead::fastest

    static constexpr void fields(auto&& io, auto& it) { io(it.speed); }
};

struct Brightness {
    static constexpr Kind kind = Kind::brightness;
    std::uint8_t brightness = 0;

    static constexpr void fields(auto&& io, auto& it) { io(it.brightness); }
};

/// What a device does when its computer falls silent, or is gone.
enum class SilenceAction : std::uint8_t {
    hold,  ///< pauses
    start, ///< plays what plays when it starts
};
constexpr bool is_known(SilenceAction action) { return action <= SilenceAction::start; }

struct Silence {
    static constexpr Kind kind = Kind::silence;
    std::uint16_t milliseconds = 0; ///< without any report; 0: nothing is done
    SilenceAction action = SilenceAction::hold;

    static constexpr void fields(auto&& io, auto& it) { io(it.milliseconds, it.action); }
};

/// A request was not carried out.
struct Failure {
    static constexpr Kind kind = Kind::error;
    static constexpr bool answers = true;
    std::uint8_t request = 0; ///< the kind of the request
    Status status = Status::ok;
    std::uint32_t number = 0; ///< the number that Status describes
    StoredText<longest_status_text> text{};

    static constexpr void fields(auto&& io, auto& it) { io(it.request, it.status, it.number, it.text); }
};

}
