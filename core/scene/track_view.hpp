#pragma once

#include "core/bytes/byte_reader.hpp"
#include "core/bytes/expects.hpp"
#include "core/math/angle.hpp"
#include "core/math/point.hpp"
#include "core/scene/format.hpp"
#include "core/scene/kfb_limits.hpp"
#include "core/scene/packed_drawing.hpp"
#include "core/scene/property.hpp"
#include "core/time/time.hpp"
#include "core/time/velocity_law.hpp"

#include <algorithm>
#include <cstdint>

namespace kfast {

/// Reads a time code of the scene format: twice the frames, or twice the ticks and one. A time beyond the
/// format's limit stays just beyond it, so that sums do not overflow before they are refused.
Time read_time_code(ByteReader& bytes);

/// Frames in 1000 seconds as the scene format has them: twice the frames in a second, or twice those in 1000
/// seconds and one. A rate beyond the format's limit stays beyond it.
constexpr std::uint32_t rate_of(std::uint32_t code)
{
    const std::uint32_t number = std::min(kfb::rate::number.get(code), kfb::max_frame_rate + 1);
    return kfb::rate::in_1000_seconds.get(code) ? number : number * 1000;
}

/// Reads a pair of velocity laws (docs/format.md, "Laws").
LawPair read_law_pair(ByteReader& bytes);

/// The time of a key, by the driver that it goes by, and the number of the pair of laws from it to the next
/// key.
struct KeyTime {
    Time time;
    std::uint32_t laws = 0;  ///< number of the pair of laws
    std::uint32_t index = 0; ///< the number of key times before it
};

/// Reads key times in the order of their times (docs/format.md, "Key times").
class KeyTimeCursor {
public:
    /// No key times.
    KeyTimeCursor() = default;
    /// A single key time, at 0.
    static KeyTimeCursor one();
    /// Reads the key times from `bytes`; `default_key_times` if they say so. Key times that are truncated or
    /// have a form without a meaning are past the end of `bytes`.
    static KeyTimeCursor take(ByteReader& bytes, const KeyTimeCursor& default_key_times);

    bool at_end() const { return index_ == count_; }
    /// Only when not at the end, and when no time before was beyond the format's limit.
    KeyTime next();
    /// Continues as if `last` had just been read.
    void go_on_behind(const KeyTime& last);
    /// Where take() has found them; null of one().
    const std::byte* place() const { return place_; }
    /// The number of all of them.
    std::uint32_t count() const { return count_; }
    /// What their times go by.
    Driver driver() const { return driver_; }

private:
    const std::byte* place_ = nullptr;
    BitReader bits_;
    std::uint32_t count_ = 0;
    std::uint32_t index_ = 0;
    Time time_;
    std::uint8_t time_bits_ = 0;
    std::uint8_t time_shift_ = 0;
    std::uint8_t law_bits_ = 0;
    Driver driver_;
};

/// One key of a track, and the interval from it to the next.
struct TrackKey {
    Time time;
    std::uint32_t laws = 0; ///< number of the pair of laws; 0 in a smooth track
    std::int32_t value = 0; ///< in the unit of the property
};

/// Reads the keys of a track in the order of their times.
class TrackKeyCursor {
public:
    TrackKeyCursor() = default;
    TrackKeyCursor(const KeyTimeCursor& key_times, const PackedValues& values, bool is_smooth = false)
        : key_times_{key_times}, values_{values}, is_smooth_{is_smooth}
    {
    }

    bool at_end() const { return key_times_.at_end(); }
    /// Only when not at the end.
    TrackKey next()
    {
        expects(!at_end());
        return at(key_times_.next());
    }
    /// What has not been read.
    const KeyTimeCursor& key_times() const { return key_times_; }
    const PackedValues& values() const { return values_; }
    TrackKey at(const KeyTime& key_time) const;

private:
    KeyTimeCursor key_times_;
    PackedValues values_;
    bool is_smooth_ = false;
};

/// One quantity of an item: a fixed value, or keys; borrows the scene's bytes.
struct TrackView {
    Property property = Property::x;
    bool is_fixed = false;
    bool is_smooth = false; ///< a cubic Hermite curve through its keys; not of a fixed track
    std::int32_t value = 0; ///< only of a fixed track
    TrackKeyCursor keys;    ///< only of a track that is not fixed
};

/// Reads the tracks of an item in the order of their properties.
class TrackCursor {
public:
    /// No tracks.
    TrackCursor() = default;
    /// `bytes` begins after the number of tracks and may go on after the last one.
    TrackCursor(ByteReader bytes, std::uint32_t count) : bytes_{bytes}, left_{count} {}

    bool at_end() const { return left_ == 0; }
    /// Only when not at the end.
    TrackView next();
    /// What has not been read.
    const ByteReader& rest() const { return bytes_; }

private:
    ByteReader bytes_;
    std::uint32_t left_ = 0;
    KeyTimeCursor key_times_; ///< of the track before
};

/// What the pivot of an item follows; borrows the scene's bytes.
struct PathView {
    bool turns = false;        ///< the item rotates as the path does
    bool is_known = false;     ///< no bit without a meaning is set
    std::uint32_t drawing = 0; ///< offset in the section of drawings: a single stroke
    ByteReader lengths;        ///< of its segments, varints in 1/16 px

    static PathView take(ByteReader& bytes);
};

/// A point on a path, and the direction of the path there.
struct PathPlace {
    Point at;
    BinaryAngle direction;
};

/// At a fraction of the length in 1/2^24, clamped to 0 … 1. The fraction within a segment is rounded to
/// 1/65536 (within one that is stored as 1/16 px long, to 1/256), the point to 3/65536 px.
PathPlace place_on(const PathView& path, PackedDrawing stroke, std::int32_t fraction);

}
