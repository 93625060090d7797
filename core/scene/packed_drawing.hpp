#pragma once

#include "core/bytes/byte_reader.hpp"
#include "core/math/flatten.hpp"
#include "core/scene/format.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// Numbers, one for each key, in as many bits as they take (docs/format.md, "Values"); borrows the
/// scene's bytes.
class PackedValues {
public:
    PackedValues() = default;
    /// Reads `count` values from `bytes`. `more` is added to each stored one.
    static PackedValues take(ByteReader& bytes, std::uint32_t count, std::int32_t more = 0);

    /// Where take() has found them.
    const std::byte* place() const { return place_; }
    /// The values as they are stored, with nothing added.
    PackedValues as_stored() const
    {
        PackedValues values = *this;
        values.more_ = 0;
        return values;
    }
    /// `index` is less than their number. Wraps around, does not overflow.
    std::int32_t operator[](std::uint32_t index) const;

private:
    const std::byte* place_ = nullptr;
    BitReader bits_;
    std::uint32_t min_ = 0;
    std::uint32_t more_ = 0;
    std::uint8_t width_ = 0;
    std::uint8_t unit_ = 0;
};

/// A stored number in its unit, 0 … kfb::values::degree_unit. Degrees become 1/65536 turn, rounded to
/// nearest; up to 30,000 of them in each direction.
constexpr std::int32_t in_unit(std::uint32_t number, std::uint32_t unit)
{
    if (unit != kfb::values::degree_unit)
        return static_cast<std::int32_t>(number << unit);
    // 65536 / 360 is 182 and 2/45.
    const std::int32_t rest = static_cast<std::int32_t>(46603 * number + (1U << 19)) >> 20;
    return static_cast<std::int32_t>(182 * number + static_cast<std::uint32_t>(rest));
}

/// What the segments of a packed stroke are; the values are those of the scene format. `repeat`: those of
/// another stroke, whose form is stored elsewhere.
enum class SegmentMix : std::uint8_t { lines, cubics, both, repeat };

/// Where a packed stroke ends; the values are those of the scene format. `turned`: the second half of the
/// segments is the first, rotated by half a turn, and is not stored.
enum class StrokeEnd : std::uint8_t { open, closed, turned };

/// How vectors are packed.
struct VectorForm {
    std::uint8_t bits = 1;  ///< of each coordinate
    bool is_sparse = false; ///< two bits say which coordinates are not 0; the others are left out

    friend bool operator==(const VectorForm&, const VectorForm&) = default;
};

/// The extent in x or y of a cubic whose control points are `out` from its beginning and `in` before its end,
/// if it is a parabola. Rounded towards 0, so that it is mirrored where they are.
constexpr std::int32_t predicted_end(std::int32_t out, std::int32_t in) { return 3 * (out + in) / 2; }

/// How the segments of a stroke are packed (docs/format.md, "Forms").
struct StrokeForm {
    /// The maximum of VectorForm::bits: the difference of two 16-bit coordinates.
    static constexpr std::uint32_t max_bits = 17;
    /// Vectors of control points have at most this many fewer bits than those of ends; more bits only if
    /// they are predicted.
    static constexpr std::uint32_t max_fewer_bits = 7;

    SegmentMix mix = SegmentMix::lines;
    StrokeEnd end = StrokeEnd::open;
    /// Whether one bit says that a first control point continues the direction of the second one before it:
    /// no if 0, exactly if 1, else but for a vector of that many bits.
    std::uint8_t smooth = 0;
    /// Bits of the first control points of cubics that are predicted: of their second control points and
    /// their ends only what differs from predicted_end() and the like is stored. 0 if they are not.
    std::uint8_t predicted = 0;
    VectorForm ends;     ///< of segments, from their beginnings
    VectorForm controls; ///< of cubics: the first from the beginning, the second from the end

    friend bool operator==(const StrokeForm&, const StrokeForm&) = default;

    /// The form of first control points.
    VectorForm first_controls() const { return predicted != 0 ? VectorForm{predicted, false} : controls; }

    /// Reads 16 bits. Bits without a meaning are ignored; packed() shows whether there were any.
    static StrokeForm unpacked(std::uint32_t head);
    std::uint32_t packed() const;
    /// Makes an unpacked form one whose curves are predicted, from a byte; predicting() shows which bits had
    /// a meaning.
    void predict(std::uint32_t byte);
    std::uint32_t predicting() const;
};

/// A key drawing as it is stored in a compiled scene (docs/format.md, "Drawings"), read in place.
class PackedDrawing {
public:
    /// `drawings` is a scene's section of drawings, `offset` less than its size. The drawing's (0, 0) is at
    /// `origin`.
    PackedDrawing(std::span<const std::byte> drawings, std::uint32_t offset, Point origin = {});

    std::uint32_t strokes() const { return strokes_; }
    std::uint32_t next_stroke();
    Point start() const { return start_; }
    Segment next_segment();

    /// Whether everything that has been read so far was within the format's limits.
    bool is_valid() const { return is_known_ && !bytes_.overrun() && !bits_.overrun(); }

private:
    ByteReader form_elsewhere(std::uint32_t head);
    void begin(std::uint32_t head, ByteReader form);
    void predict(std::uint32_t byte);
    void move_start();
    void turn();
    Segment predicted_cubic(Point from);
    bool closes() const { return left_ == 0 && form_.end == StrokeEnd::closed; }
    Point vector(const VectorForm& form);
    Point wide_vector(const VectorForm& form);
    Point first_control();
    Point flipped(std::int32_t x, std::int32_t y) const;

    std::span<const std::byte> drawings_;
    ByteReader bytes_; ///< after the stroke that was begun, if its form is elsewhere
    std::uint32_t strokes_;
    StrokeForm form_;
    bool is_elsewhere_ = true;
    bool is_known_ = true;
    std::uint32_t left_ = 0;  ///< segments of the stroke
    std::uint32_t half_ = 0;  ///< how many are left where it turns; 0 if it does not
    BitReader bits_;          ///< of these
    std::int32_t flip_x_ = 0; ///< -1 where x is mirrored, else 0
    std::int32_t flip_y_ = 0;
    Point start_;
    Point at_;      ///< the end of the segment read last
    Point onwards_; ///< as far from there as its second control point, opposite; 0 after a line
};

/// `drawings` is a scene's section of drawings, `offset` within it.
inline PackedDrawing drawing_at(std::span<const std::byte> drawings, std::uint32_t offset)
{
    return {drawings, offset};
}

}
