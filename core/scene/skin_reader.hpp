#pragma once

#include "core/bytes/byte_reader.hpp"

#include <cstdint>

namespace kfast {

/// A bone, and how far a point follows it.
struct BoneInfluence {
    std::uint32_t bone = 0;    ///< its number in the skeleton
    std::int32_t weight = 256; ///< in 1/256; those of a point add up to 256
};

/// The bones that carry a point, one to four; borrows the scene's bytes.
class Binding {
public:
    Binding() = default;
    /// One bone alone.
    explicit Binding(std::uint32_t bone) : last_{bone} {}
    /// Takes `bytes` as far as the bones go.
    Binding(ByteReader& bytes, std::uint32_t count);

    std::uint32_t count() const { return count_; }
    /// The number of the last bone.
    std::uint32_t last() const { return last_; }

    /// Calls use(BoneInfluence) for each bone.
    template <class Use>
    void each(Use use) const
    {
        ByteReader bytes = bytes_;
        std::int32_t rest = 256;
        for (std::uint32_t i = 1; i < count_; ++i) {
            const std::uint32_t bone = bytes.u8();
            const auto weight = static_cast<std::int32_t>(bytes.u8());
            rest -= weight;
            use(BoneInfluence{bone, weight});
        }
        use(BoneInfluence{last_, rest});
    }

private:
    ByteReader bytes_;
    std::uint32_t count_ = 1;
    std::uint32_t last_ = 0; ///< number of the last bone, which has no weight of its own
};

/// Reads the bindings of a drawing's points in their order: each stroke's first point and the ends of its
/// segments (docs/format.md, "Skins").
class SkinReader {
public:
    SkinReader() = default;
    /// `bytes` begins with the skin and may go on after it.
    explicit SkinReader(ByteReader bytes) : bytes_{bytes}, at_rest_{bytes_.varint()} {}
    /// One bone carries all points.
    static SkinReader of(std::uint32_t bone);

    /// The drawing at rest has an offset; otherwise the drawing itself is at rest.
    bool has_drawing_at_rest() const { return at_rest_ != 0; }
    std::uint32_t drawing_at_rest() const { return at_rest_ - 1; }

    /// There is one more point.
    const Binding& next();
    /// What next() returned last.
    const Binding& binding() const { return binding_; }

    /// Whether everything that has been read so far was within the bytes.
    bool is_valid() const { return !bytes_.overrun(); }
    /// No more points belong to the run that was read last.
    bool run_is_over() const { return left_ == 0; }

private:
    ByteReader bytes_;
    std::uint32_t at_rest_ = 0;
    std::uint32_t left_ = 0; ///< points of the run
    Binding binding_;
};

}
