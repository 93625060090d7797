#pragma once

#include "core/input_view.hpp"
#include "core/kfb_limits.hpp"
#include "core/live_drawing.hpp"
#include "core/size.hpp"
#include "core/time.hpp"
#include "firmware/link/report.hpp"
#include "firmware/status.hpp"
#include "firmware/stored_text.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

/// What the reports of the link mean (docs/link.md). Each message is a struct whose fields() names its fields
/// in the order of their bytes, for writing and reading (fields.hpp).
namespace kfast::link {

/// Goes up when a computer or a device that knows the number before cannot understand what is meant.
inline constexpr std::uint8_t protocol_version = 1;

/// Byte 0 of a report. What answers a request has the same number and `from_device`.
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

/// Names of scenes and clips.
using Name = StoredText<24>;

/// Where a scene lies.
enum class Home : std::uint8_t {
    built_in, ///< where a UF2 file puts it
    slot,
    ram,
    here,  ///< only in Play: where what plays now lies
    start, ///< only in Play: what plays when the device starts
};
constexpr bool is_known(Home home) { return home <= Home::start; }

/// Stands for a slot where there is none.
inline constexpr std::uint8_t no_slot = 0xFF;

/// Bytes of the scene in a data report; only the last has fewer.
inline constexpr std::size_t block_bytes = payload_bytes - 2;
/// The numbers of blocks have 16 bits, and that behind the last is one, too.
inline constexpr std::uint32_t most_blocks = 0xFFFF;
constexpr std::uint32_t blocks_of(std::uint32_t bytes)
{
    constexpr std::uint32_t each{block_bytes};
    return bytes / each + (bytes % each != 0 ? 1 : 0);
}

/// A request that has nothing but its kind.
template <Kind which>
struct Plain {
    static constexpr Kind kind = which;
    static constexpr void fields(auto&&, auto&) {}
};

/// An answer that has nothing to tell but that it was done.
template <Kind which>
struct Done : Plain<which> {
    static constexpr bool answers = true;
};

using Hello = Plain<Kind::hello>;
using AskNames = Plain<Kind::names>;
using AskPlaying = Plain<Kind::playing>;
using AskStatistics = Plain<Kind::statistics>;
using Commit = Plain<Kind::commit>;
using Cancel = Plain<Kind::cancel>;
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
    bool is_playing = false; ///< else there is no scene that can be played, and the rest is empty
    bool is_paused = false;
    Home home = Home::built_in;
    std::uint8_t slot = no_slot;
    std::uint8_t brightness = 0;
    std::uint8_t inputs = 0; ///< how many the scene has
    Size canvas{};
    std::uint32_t frame_rate = 0; ///< in frames per 1000 seconds
    Time length{};                ///< of the scene
    Time moment{};                ///< where playing stands
    std::int32_t speed = 0;       ///< Q16 of the authored one
    Name clip{};                  ///< empty: the whole scene
    Arming arming = Arming::none; ///< also if nothing plays

    static constexpr void fields(auto&& io, auto& it)
    {
        io(it.is_playing, it.is_paused, it.home, it.slot, it.brightness, it.inputs, it.canvas, it.frame_rate,
           it.length, it.moment, it.speed, it.clip, it.arming);
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

    static constexpr void fields(auto&& io, auto& it) { io(it.frames, it.late, it.skipped, it.link_errors); }
};

struct AskInput {
    static constexpr Kind kind = Kind::input;
    std::uint8_t input = 0; ///< its number in the scene that plays

    static constexpr void fields(auto&& io, auto& it) { io(it.input); }
};

/// What an input of a scene takes.
enum class InputKind : std::uint8_t {
    number = 0,
    text = 1,
    drawing = 2,
};
/// A later device may have more of them.
constexpr bool is_known(InputKind) { return true; }
constexpr InputKind input_kind(InputType type) { return static_cast<InputKind>(type); }
static_assert(input_kind(InputType::number) == InputKind::number &&
              input_kind(InputType::text) == InputKind::text &&
              input_kind(InputType::drawing) == InputKind::drawing);

/// One input of the scene that plays. Values, which only a number has, are in 1/1000; of a text `most` alone
/// counts, its characters.
struct InputState {
    static constexpr Kind kind = Kind::input;
    static constexpr bool answers = true;
    std::uint8_t input = 0;
    InputKind takes = InputKind::number;
    Name name{}; ///< its first 24 bytes, in whole letters
    std::int32_t least = 0;
    std::int32_t most = 0;
    std::int32_t usual = 0; ///< until another is told
    Time place{};           ///< where it stands: 0 … whole_input

    static constexpr void fields(auto&& io, auto& it)
    {
        io(it.input, it.takes, it.name, it.least, it.most, it.usual, it.place);
    }
};

/// A scene is going to come. Its tag is that of all that belongs to the upload.
struct Begin {
    static constexpr Kind kind = Kind::begin;
    Home home = Home::slot; ///< slot or ram
    std::uint8_t slot = no_slot;
    std::uint32_t size = 0; ///< bytes
    std::uint32_t crc = 0;  ///< CRC-32 of all bytes (core/crc32.hpp)
    Name name{};

    static constexpr void fields(auto&& io, auto& it) { io(it.home, it.slot, it.size, it.crc, it.name); }
    friend constexpr bool operator==(const Begin&, const Begin&) = default;
};

struct Data {
    static constexpr Kind kind = Kind::data;
    std::uint16_t block = 0;
    std::array<std::byte, block_bytes> bytes{};

    static constexpr void fields(auto&& io, auto& it) { io(it.block, it.bytes); }
};

/// How far an upload has come: the answer to begin, and told again and again while data come.
template <Kind which>
struct Progress {
    static constexpr Kind kind = which;
    static constexpr bool answers = true;
    std::uint16_t next = 0;   ///< the block that is wanted: all before it have come
    std::uint16_t window = 0; ///< how many blocks from there may be on the way
    bool is_missing = false;  ///< a later block has come: begin again from `next`

    static constexpr void fields(auto&& io, auto& it) { io(it.next, it.window, it.is_missing); }
    friend constexpr bool operator==(const Progress&, const Progress&) = default;
};
using Begun = Progress<Kind::begin>;
using Acknowledgement = Progress<Kind::data>;

/// About one slot: what it holds, erase it, or play it when the device starts.
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

/// From the beginning, as authored.
struct Play {
    static constexpr Kind kind = Kind::play;
    Home home = Home::here;
    std::uint8_t slot = no_slot; ///< only of Home::slot
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

struct InputPlace {
    std::uint8_t input = 0; ///< its number in the scene
    Time place{};           ///< 0 … whole_input (core/clock.hpp)

    static constexpr void fields(auto&& io, auto& it) { io(it.input, it.place); }
    friend constexpr bool operator==(const InputPlace&, const InputPlace&) = default;
};

/// Where inputs of the scene that plays stand from now on.
struct Inputs {
    static constexpr Kind kind = Kind::inputs;
    static constexpr std::size_t most = 12;
    std::uint8_t count = 0;
    std::array<InputPlace, most> places{};

    static constexpr void fields(auto&& io, auto& it) { io(it.count, it.places); }
};

/// What a text among the inputs of the scene that plays is from now on.
struct Text {
    static constexpr Kind kind = Kind::text;
    static constexpr std::size_t most = payload_bytes - 2;
    std::uint8_t input = 0;              ///< its number in the scene
    std::uint8_t length = 0;             ///< bytes
    std::array<std::byte, most> bytes{}; ///< in UTF-8

    /// `length` is at most `most`.
    std::string_view view() const { return {reinterpret_cast<const char*>(bytes.data()), length}; }

    static constexpr void fields(auto&& io, auto& it) { io(it.input, it.length, it.bytes); }
};

/// Whose points they are: a drawing among the inputs of the scene that plays, and a number that tells it from
/// the ones before.
struct DrawingNumber {
    static constexpr std::uint8_t count = 8; ///< numbers go round

    std::uint8_t input = 0; ///< below kfb::max_inputs
    std::uint8_t number = 0;

    static constexpr DrawingNumber of(std::uint8_t code)
    {
        return {static_cast<std::uint8_t>(code % kfb::max_inputs),
                static_cast<std::uint8_t>(code / kfb::max_inputs)};
    }
    constexpr std::uint8_t code() const
    {
        return static_cast<std::uint8_t>(input + number * kfb::max_inputs);
    }
    friend constexpr bool operator==(DrawingNumber, DrawingNumber) = default;
};
static_assert(kfb::max_inputs * DrawingNumber::count == 256);

/// In place of a point: the next one begins a stroke.
inline constexpr LivePoint pen_up{std::numeric_limits<std::int16_t>::min(), 0};

/// Of a drawing, in their order: part 0 begins it.
struct Points {
    static constexpr Kind kind = Kind::points;
    static constexpr std::size_t most = 15;
    std::uint8_t which = 0; ///< DrawingNumber
    std::uint8_t part = 0;  ///< how many come before, modulo 256
    std::array<LivePoint, most> points{};

    static constexpr void fields(auto&& io, auto& it) { io(it.which, it.part, it.points); }
};

/// The last points of a drawing, which is to be shown.
struct Drawing {
    static constexpr Kind kind = Kind::drawing;
    static constexpr std::size_t most = 14;
    std::uint8_t which = 0;  ///< DrawingNumber
    std::uint8_t part = 0;   ///< how many come before, modulo 256
    std::uint16_t count = 0; ///< of all points of the drawing and of what stands in place of one
    std::array<LivePoint, most> points{};

    static constexpr void fields(auto&& io, auto& it) { io(it.which, it.part, it.count, it.points); }
};

/// How many reports a drawing with so many points, and what stands in place of one, takes.
constexpr std::size_t reports_of_drawing(std::size_t count)
{
    return count <= Drawing::most ? 1 : 1 + (count - Drawing::most + Points::most - 1) / Points::most;
}

/// What a device does when its computer falls silent, or goes.
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

/// Something that was asked for was not done.
struct Failure {
    static constexpr Kind kind = Kind::error;
    static constexpr bool answers = true;
    std::uint8_t request = 0; ///< the kind of what was asked for
    Status status = Status::ok;
    std::uint32_t number = 0; ///< what Status says it is
    StoredText<longest_status_text> text{};

    static constexpr void fields(auto&& io, auto& it) { io(it.request, it.status, it.number, it.text); }
};

}
