#pragma once

#include "core/bytes/byte_reader.hpp"
#include "core/bytes/expects.hpp"
#include "core/scene/format.hpp"
#include "core/scene/packed_drawing.hpp"
#include "core/scene/track_view.hpp"
#include "core/time/time.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace kfast {

/// What poses change of a bone, in the frame of its parent; the values are those of the scene format.
enum class BoneQuantity : std::uint8_t {
    angle,  ///< clockwise from the parent's direction, in 1/65536 turn
    x,      ///< of the origin, in 1/16 px
    y,      ///< of the origin, in 1/16 px
    length, ///< in 1/16 px
};

inline constexpr std::size_t bone_quantity_count = 4;

/// The keys of one quantity of a bone: none, keys of its own, or the common keys with a value for each.
class BoneKeys {
public:
    enum class Kind : std::uint8_t { none, common, own };

    BoneKeys() = default;
    /// Reads the keys from `bytes`. Values are stored as differences from `set_up`.
    static BoneKeys take(ByteReader& bytes, const KeyTimeCursor& common, std::int32_t set_up);

    Kind kind() const { return kind_; }
    /// Also those of Kind::common; not of Kind::none.
    TrackKeyCursor keys() const { return {key_times_, values_}; }
    /// As they are stored: differences from the bone as set up.
    PackedValues values() const { return values_.as_stored(); }

private:
    Kind kind_ = Kind::none;
    KeyTimeCursor key_times_;
    PackedValues values_;
};

/// A bone as set up.
struct BoneSetUp {
    std::uint32_t parent = 0;      ///< 0 for a root, else the number of an earlier bone, counted from 1
    bool is_at_tip = false;        ///< the origin moves with the length of the parent
    bool turns_as_written = false; ///< angles tween as numbers, not by the smallest rotation
    std::uint8_t moved = 0;        ///< a bit for each BoneQuantity that has keys
    std::array<std::int32_t, bone_quantity_count> set_up = {}; ///< by BoneQuantity, in its units

    static BoneSetUp take(ByteReader& bytes);

    std::int32_t at_rest(BoneQuantity quantity) const { return set_up[static_cast<std::size_t>(quantity)]; }
};

/// A bone, and what moves it; borrows the scene's bytes.
struct BoneView : BoneSetUp {
    std::array<BoneKeys, bone_quantity_count> keys = {};

    const BoneKeys& keys_of(BoneQuantity quantity) const { return keys[static_cast<std::size_t>(quantity)]; }
};

/// Reads the bones of a skeleton, parents before their children.
class BoneCursor {
public:
    BoneCursor(ByteReader bytes, std::uint32_t count, const KeyTimeCursor& common)
        : bytes_{bytes}, left_{count}, common_{common}
    {
    }

    bool at_end() const { return left_ == 0; }
    /// Only when not at the end.
    BoneView next();
    /// What has not been read.
    const ByteReader& rest() const { return bytes_; }

private:
    ByteReader bytes_;
    std::uint32_t left_;
    KeyTimeCursor common_;
};

/// A skeleton of bones: one tree or several; borrows the scene's bytes.
class SkeletonView {
public:
    explicit SkeletonView(ByteReader bytes);

    std::uint32_t count() const { return count_; }
    /// The key times that several quantities have in common; maybe none.
    KeyTimeCursor common_key_times() const { return common_; }
    BoneCursor bones() const { return {bones_, count_, common_}; }

private:
    std::uint32_t count_;
    KeyTimeCursor common_;
    ByteReader bones_;
};

/// Reads the skeletons of a scene.
class SkeletonCursor {
public:
    explicit SkeletonCursor(ByteReader bytes) : bytes_{bytes} {}

    bool at_end() const { return bytes_.left() == 0; }
    /// Only when not at the end.
    SkeletonView next()
    {
        expects(!at_end());
        return SkeletonView{bytes_.take(bytes_.varint())};
    }
    /// Skips the next skeleton without reading its keys, which may be many. Returns the number of its bones.
    /// Only when not at the end.
    std::uint32_t skip()
    {
        expects(!at_end());
        return bytes_.take(bytes_.varint()).u8();
    }
    bool overrun() const { return bytes_.overrun(); }

private:
    ByteReader bytes_;
};

/// The backbones of an object at one key, and the interval from it to the next.
struct BackboneKey {
    Time time;
    std::uint32_t laws = 0;    ///< number of the pair of laws
    std::uint32_t drawing = 0; ///< offset in the section of drawings
};

/// Reads the keys of backbones in the order of their times.
class BackboneKeyCursor {
public:
    /// Reads the keys from `bytes`.
    explicit BackboneKeyCursor(ByteReader& bytes);

    bool at_end() const { return key_times_.at_end(); }
    /// Only when not at the end.
    BackboneKey next();
    /// What has not been read.
    const KeyTimeCursor& key_times() const { return key_times_; }
    const PackedValues& drawings() const { return drawings_; }

private:
    KeyTimeCursor key_times_;
    PackedValues drawings_;
};

/// The backbones that deform an object; borrows the scene's bytes.
struct BackbonesView {
    std::uint32_t unit_bits = 0; ///< a segment, and a width, are 2^unit_bits sixteenths of a pixel long
    ByteReader key_bytes;        ///< begins with the keys

    BackboneKeyCursor keys() const
    {
        ByteReader bytes = key_bytes;
        return BackboneKeyCursor{bytes};
    }
};

/// The number of nodes and gaps for the backbones of `drawing`, three strokes each.
std::size_t backbone_node_count(PackedDrawing drawing);

/// A bone, and how much a point follows it.
struct BoneInfluence {
    std::uint32_t bone = 0;                        ///< its number in the skeleton
    std::int32_t weight = kfb::skin::whole_weight; ///< in 1/65536; those of a point add up to 65,536
};

/// The bones that move a point, one to four; borrows the scene's bytes.
class Binding {
public:
    Binding() = default;
    /// One bone alone.
    explicit Binding(std::uint32_t bone) : last_{bone} {}
    /// Reads that of a run from `bytes`. `head` is the varint with which the run begins.
    Binding(ByteReader& bytes, std::uint32_t head);

    std::uint32_t count() const { return count_; }
    /// The number of the last bone.
    std::uint32_t last() const { return last_; }

    /// Calls use(BoneInfluence) for each bone.
    template <class Use>
    void each(Use use) const
    {
        ByteReader bytes = bytes_;
        std::int32_t rest = kfb::skin::whole_weight;
        for (std::uint32_t i = 1; i < count_; ++i) {
            const std::uint32_t bone = bytes.u8();
            const std::int32_t weight = weight_from(bytes);
            rest -= weight;
            use(BoneInfluence{bone, weight});
        }
        use(BoneInfluence{last_, rest});
    }

private:
    std::int32_t weight_from(ByteReader& bytes) const
    {
        return static_cast<std::int32_t>(is_fine_ ? bytes.u16() : bytes.u8() * kfb::skin::coarse_weight);
    }

    ByteReader bytes_;
    std::uint32_t count_ = 1;
    bool is_fine_ = false;
    std::uint32_t last_ = 0; ///< number of the last bone, which has no weight of its own
};

/// Reads the bindings of a drawing's points in their order: each stroke's first point and the ends of its
/// segments (docs/format.md, "Skins").
class SkinReader {
public:
    SkinReader() = default;
    /// `bytes` begins with the skin and may go on after it.
    explicit SkinReader(ByteReader bytes) : bytes_{bytes}, at_rest_{bytes_.varint()} {}
    /// A skin with which one bone moves all points.
    static SkinReader of(std::uint32_t bone);

    /// Whether the drawing at rest has an offset; otherwise the drawing itself is at rest.
    bool has_drawing_at_rest() const { return at_rest_ != 0; }
    std::uint32_t drawing_at_rest() const { return at_rest_ - 1; }

    /// The binding of the next point; only if there is one more.
    const Binding& next();
    /// What next() returned last.
    const Binding& binding() const { return binding_; }

    /// Whether everything that has been read so far was within the bytes.
    bool is_valid() const { return !bytes_.overrun(); }
    /// Whether no more points belong to the run that was read last.
    bool run_is_over() const { return left_ == 0; }

private:
    ByteReader bytes_;
    std::uint32_t at_rest_ = 0;
    std::uint32_t left_ = 0; ///< points of the run
    Binding binding_;
};

}
