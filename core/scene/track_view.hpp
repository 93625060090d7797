#pragma once

#include "core/bytes/byte_reader.hpp"
#include "core/scene/key_time_cursor.hpp"
#include "core/scene/packed_values.hpp"
#include "core/scene/property.hpp"
#include "core/time/time.hpp"

#include <cstdint>

namespace kfast {

/// One key of a track, and the way from it to the next.
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
    TrackKey next() { return at(key_times_.next()); }
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
    bool is_smooth = false; ///< between its keys runs a cubic Hermite curve; not of a fixed track
    std::int32_t value = 0; ///< only of a fixed track
    TrackKeyCursor keys;    ///< only of a track that is not fixed
};

/// Reads the tracks of an item in the order of their properties.
class TrackCursor {
public:
    /// No tracks.
    TrackCursor() = default;
    /// `bytes` begins behind the number of tracks and may go on after the last one.
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

}
