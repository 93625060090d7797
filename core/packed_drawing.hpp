#pragma once

#include "core/byte_reader.hpp"
#include "core/segment.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// How the segments of a packed stroke are told apart; the values are those of the scene format.
enum class SegmentMix : std::uint8_t { lines, cubics, both };

/// Numbers of one stroke are at most this wide: the difference of two 16-bit coordinates.
inline constexpr std::uint32_t max_delta_bits = 17;

/// A key drawing as it lies in a compiled scene (docs/format.md, "Drawings"), read in place.
class PackedDrawing {
public:
    /// `bytes` begins with the drawing and may go on after it.
    explicit PackedDrawing(ByteReader bytes) : bytes_{bytes}, strokes_{bytes_.varint()} {}

    std::uint32_t strokes() const { return strokes_; }
    std::uint32_t next_stroke();
    Point start() const { return start_; }
    Segment next_segment();

    /// Whether everything that has been read so far was within the format's limits.
    bool is_sound() const { return sound_ && !bytes_.overrun(); }

private:
    struct Sixteenths {
        std::int32_t x = 0;
        std::int32_t y = 0;
    };

    std::int32_t bits(std::uint32_t count);
    Sixteenths delta_from(Sixteenths origin);
    Point checked(Sixteenths at);

    ByteReader bytes_;
    std::uint32_t strokes_;
    Point start_;
    Sixteenths at_; ///< the end of the segment read last
    SegmentMix mix_ = SegmentMix::lines;
    std::uint32_t delta_bits_ = 0;
    std::uint32_t pending_ = 0; ///< bits that were read from the bytes but not used yet
    std::uint32_t pending_count_ = 0;
    bool sound_ = true;
};

/// `drawings` is a scene's section of drawings, `offset` within it.
PackedDrawing drawing_at(std::span<const std::byte> drawings, std::uint32_t offset);

}
