#pragma once

#include <cstdint>

namespace kfast {

/// What the segments of a packed stroke are; the values are those of the scene format. `repeat`: those of
/// another stroke, whose form lies elsewhere.
enum class SegmentMix : std::uint8_t { lines, cubics, both, repeat };

/// Where a packed stroke ends; the values are those of the scene format. `turned`: the second half of the
/// segments is the first, turned by half a turn, and is not stored.
enum class StrokeEnd : std::uint8_t { open, closed, turned };

/// How vectors are packed.
struct VectorForm {
    std::uint8_t bits = 1;  ///< of each coordinate
    bool is_sparse = false; ///< two bits tell which coordinates are not 0; the others are left out

    friend bool operator==(const VectorForm&, const VectorForm&) = default;
};

/// How far a cubic leads in x or y whose control points are `out` from its beginning and `in` before its end,
/// if it is no more than a parabola. Towards 0, so that it is mirrored where they are.
constexpr std::int32_t predicted_end(std::int32_t out, std::int32_t in) { return 3 * (out + in) / 2; }

/// How the segments of a stroke are packed (docs/format.md, "Strokes").
struct StrokeForm {
    /// Vectors have at most so many bits: the difference of two 16-bit coordinates.
    static constexpr std::uint32_t max_bits = 17;
    /// Those of control points have fewer than those of ends by at most this; more only if they are
    /// predicted.
    static constexpr std::uint32_t max_fewer_bits = 7;

    SegmentMix mix = SegmentMix::lines;
    StrokeEnd end = StrokeEnd::open;
    /// Whether one bit tells that a first control point goes on where the second one before came from: not at
    /// all if 0, exactly if 1, else but for a vector of so many bits.
    std::uint8_t smooth = 0;
    /// Bits of the first control points of cubics that are predicted: of their second control points and
    /// their ends only what differs from predicted_end() and the like is stored. 0 if they are not.
    std::uint8_t predicted = 0;
    VectorForm ends;     ///< of segments, from their beginnings
    VectorForm controls; ///< of cubics: the first from the beginning, the second from the end

    friend bool operator==(const StrokeForm&, const StrokeForm&) = default;

    /// Of first control points.
    VectorForm first_controls() const { return predicted != 0 ? VectorForm{predicted, false} : controls; }

    /// Of 16 bits. What has no meaning in them is left out: packed() tells.
    static StrokeForm unpacked(std::uint32_t head);
    std::uint32_t packed() const;
    /// Makes a form that is unpacked one whose curves are predicted, from a byte; predicting() tells what had
    /// a meaning.
    void predict(std::uint32_t byte);
    std::uint32_t predicting() const;
};

}
