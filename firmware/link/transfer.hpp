#pragma once

#include "core/bytes/crc32.hpp"
#include "core/bytes/expects.hpp"
#include "firmware/chip/microseconds.hpp"
#include "firmware/link/sink.hpp"
#include "firmware/link/upload_message.hpp"
#include "firmware/status.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace kfast::link {

/// A scene on its way to the device: takes its blocks in order and reports its progress to the computer.
///
/// What comes twice is ignored. If a block is missing, those after it are ignored as well, and the computer
/// is asked to begin again from there: once when it is seen, and once for every `acknowledge_every` blocks
/// that come nevertheless.
class Transfer {
public:
    /// How many blocks may be on the way.
    static constexpr std::uint16_t window = 64;
    /// How many blocks come before one is acknowledged.
    static constexpr std::uint16_t acknowledge_every = 16;
    /// How long the next block may take.
    static constexpr Microseconds patience{3'000'000};

    /// Begins a new one, whatever was before. At most max_blocks.
    void begin(const Begin& what, std::uint8_t tag, Microseconds now);
    /// Now there is none, nor has there been.
    void forget() { *this = {}; }

    /// The scene that comes, or came last.
    const Begin& what() const { return what_; }
    std::uint8_t tag() const { return tag_; }
    bool is_under_way() const { return state_ == State::under_way; }
    /// Whether this beginning was acknowledged before: then the transfer continues where it is, even if it
    /// has ended.
    bool is_begun_by(const Begin& what, std::uint8_t tag) const
    {
        return (is_under_way() || result_ == Status::ok) && belongs(tag) && what == what_;
    }
    /// Whether this tag is that of the scene that comes, or came last.
    bool belongs(std::uint8_t tag) const { return state_ != State::none && tag == tag_; }
    /// Whether the next block has not come in time.
    bool is_overdue(Microseconds now) const { return is_under_way() && reached(now, progressed_ + patience); }

    /// Takes a block that belongs to the transfer.
    template <Sink S>
    void take(const Data& data, S& sink, Microseconds now)
    {
        if (is_under_way() && is_wanted(data.block))
            sink.write(next_bytes(data, now));
    }

    /// Ends the transfer if all its blocks have come; asked again, it answers the same. Fails with
    /// incomplete, and then it continues; otherwise with bad_checksum or the error of the sink.
    template <Sink S>
    StatusWithNumber commit(S& sink)
    {
        if (state_ == State::ended)
            return result_;
        if (next_ != blocks_)
            return {Status::incomplete, next_};
        end(crc_.value() == what_.crc ? sink.finish() : Status::bad_checksum);
        return result_;
    }
    /// Ends the transfer because of `why`, which is not ok.
    void fail(Status why)
    {
        expects(why != Status::ok);
        end(why);
    }

    Begun begun() const { return {.next = next_, .window = window}; }
    bool has_acknowledgement() const { return acknowledged_ == Acknowledged::not_yet; }
    /// Its progress, if that is to be acknowledged now.
    std::optional<Acknowledgement> next_acknowledgement();

private:
    enum class State : std::uint8_t { none, under_way, ended };
    enum class Acknowledged : std::uint8_t { all, not_yet };

    bool is_wanted(std::uint16_t block);
    std::span<const std::byte> next_bytes(const Data& data, Microseconds now);
    void end(Status result);
    void acknowledge_soon() { acknowledged_ = Acknowledged::not_yet; }

    State state_ = State::none;
    Status result_ = Status::ok; ///< if it has ended
    std::uint8_t tag_ = 0;
    Begin what_;
    std::uint16_t blocks_ = 0;
    std::uint16_t next_ = 0;
    std::uint16_t unacknowledged_ = 0; ///< blocks that were taken
    std::uint16_t untimely_ = 0;       ///< blocks that came too early since the last one that was taken
    Acknowledged acknowledged_ = Acknowledged::all;
    bool is_missing_ = false; ///< what is to be acknowledged next
    Crc32 crc_;
    Microseconds progressed_;
};

}
