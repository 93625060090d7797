#pragma once

#include "core/bone_quantity.hpp"
#include "core/byte_reader.hpp"
#include "core/time.hpp"
#include "core/track_view.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace kfast {

/// A moment at which several quantities of bones have a key, and the way from it to the next such moment.
struct CommonKey {
    Time time;
    std::uint32_t laws = 0;  ///< number of the pair of laws
    std::uint32_t index = 0; ///< how many come before
};

/// Reads the common keys of a skeleton in the order of their times.
class CommonKeyCursor {
public:
    CommonKeyCursor() = default;
    /// `bytes` begins behind their number and may go on after the last one.
    CommonKeyCursor(ByteReader bytes, std::uint32_t count) : bytes_{bytes}, count_{count} {}

    bool at_end() const { return index_ == count_; }
    /// Only when not at the end.
    CommonKey next();
    std::uint32_t count() const { return count_; }
    /// What has not been read.
    const ByteReader& rest() const { return bytes_; }

private:
    ByteReader bytes_;
    std::uint32_t count_ = 0;
    std::uint32_t index_ = 0;
    Time time_;
};

/// What moves one quantity of a bone: nothing, keys of its own, or the common keys with a value for each.
class BoneKeys {
public:
    enum class Kind : std::uint8_t { none, common, own };

    BoneKeys() = default;
    /// Takes `bytes` as far as the keys go; there are `common` common keys.
    static BoneKeys take(ByteReader& bytes, BoneQuantity quantity, std::uint32_t common);

    Kind kind() const { return kind_; }
    /// Only of Kind::own.
    TrackKeyCursor own() const { return TrackKeyCursor{bytes_}; }
    /// At the common key `index`; only of Kind::common.
    std::int32_t common(std::uint32_t index) const;

private:
    Kind kind_ = Kind::none;
    bool is_signed_ = false;
    ByteReader bytes_;
};

/// A bone as set up, and what moves it; borrows the scene's bytes.
struct BoneView {
    std::uint32_t parent = 0;      ///< 0 for a root, else the number of an earlier bone, counted from 1
    bool is_known = false;         ///< no bit is set without a meaning
    bool is_at_tip = false;        ///< the origin moves with the length of the parent
    bool turns_as_written = false; ///< angles tween as numbers, not by the shortest way
    std::array<std::int32_t, bone_quantity_count> set_up = {}; ///< by BoneQuantity, in its units
    std::array<BoneKeys, bone_quantity_count> keys = {};

    std::int32_t at_rest(BoneQuantity quantity) const { return set_up[static_cast<std::size_t>(quantity)]; }
    const BoneKeys& keys_of(BoneQuantity quantity) const { return keys[static_cast<std::size_t>(quantity)]; }
};

/// Reads the bones of a skeleton, parents before their children.
class BoneCursor {
public:
    BoneCursor(ByteReader bytes, std::uint32_t count, std::uint32_t common)
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
    std::uint32_t common_;
};

/// A skeleton of bones: one tree or several; borrows the scene's bytes.
class BonesView {
public:
    explicit BonesView(ByteReader bytes);

    std::uint32_t count() const { return count_; }
    CommonKeyCursor common_keys() const { return common_; }
    BoneCursor bones() const { return {bones_, count_, common_.count()}; }

private:
    std::uint32_t count_;
    CommonKeyCursor common_;
    ByteReader bones_;
};

/// Reads the skeletons of a scene.
class BonesCursor {
public:
    explicit BonesCursor(ByteReader bytes) : bytes_{bytes} {}

    bool at_end() const { return bytes_.left() == 0; }
    /// Only when not at the end.
    BonesView next() { return BonesView{bytes_.take(bytes_.varint())}; }
    /// Passes the next skeleton without a look at its keys, which may be many; how many bones it has. Only
    /// when not at the end.
    std::uint32_t skip() { return bytes_.take(bytes_.varint()).u8(); }
    bool overrun() const { return bytes_.overrun(); }

private:
    ByteReader bytes_;
};

}
