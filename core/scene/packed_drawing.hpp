#pragma once

#include "core/bytes/bit_reader.hpp"
#include "core/bytes/byte_reader.hpp"
#include "core/math/segment.hpp"
#include "core/scene/stroke_form.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// A key drawing as it lies in a compiled scene (docs/format.md, "Drawings"), read in place.
class PackedDrawing {
public:
    /// `drawings` is a scene's section of drawings, `offset` less than its size. The drawing's (0, 0) lies at
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
    ByteReader bytes_; ///< behind the stroke that was begun, if its form lies elsewhere
    std::uint32_t strokes_;
    StrokeForm form_;
    bool is_elsewhere_ = true;
    bool is_known_ = true;
    std::uint32_t left_ = 0;  ///< segments of the stroke
    std::uint32_t half_ = 0;  ///< how many are left where it turns; 0 if it does not
    BitReader bits_;          ///< of these
    std::int32_t flip_x_ = 0; ///< -1 where x runs the other way, else 0
    std::int32_t flip_y_ = 0;
    Point start_;
    Point at_;      ///< the end of the segment read last
    Point onwards_; ///< as far from there as its second control point, opposite; 0 behind a line
};

/// `drawings` is a scene's section of drawings, `offset` within it.
inline PackedDrawing drawing_at(std::span<const std::byte> drawings, std::uint32_t offset)
{
    return {drawings, offset};
}

}
