#pragma once

#include "core/bytes/byte_reader.hpp"
#include "core/time/time.hpp"

#include <cstdint>
#include <string_view>

namespace kfast {

/// A named stretch of the timeline; borrows the scene's bytes.
struct ClipView {
    std::string_view name; ///< UTF-8
    Time begin;
    Time end; ///< later than `begin`
    Loop loop = Loop::once;
};

/// A named moment of the timeline; borrows the scene's bytes.
struct EventView {
    std::string_view name; ///< UTF-8
    Time time;
};

/// Reads the clips of a scene in their order.
class ClipCursor {
public:
    ClipCursor(ByteReader bytes, std::uint32_t count) : bytes_{bytes}, left_{count} {}

    bool at_end() const { return left_ == 0; }
    /// Only when not at the end.
    ClipView next();
    /// What has not been read: the events, after the last clip.
    const ByteReader& rest() const { return bytes_; }

private:
    ByteReader bytes_;
    std::uint32_t left_;
};

/// Reads the events of a scene in the order of their times.
class EventCursor {
public:
    explicit EventCursor(ByteReader bytes) : bytes_{bytes} {}

    bool at_end() const { return bytes_.left() == 0; }
    /// Only when not at the end.
    EventView next();
    bool overrun() const { return bytes_.overrun(); }

private:
    ByteReader bytes_;
    Time time_;
};

}
