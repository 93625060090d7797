#pragma once

#include "core/byte_reader.hpp"
#include "core/packed_drawing.hpp"
#include "core/stroke_style.hpp"
#include "core/time.hpp"
#include "core/velocity_law.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace kfast {

/// How an object is painted: filled, stroked or both, the stroke over the fill.
struct ObjectStyle {
    bool is_filled = false;
    bool is_stroked = false;
    std::uint8_t fill = 0;   ///< index of the palette
    std::uint8_t stroke = 0; ///< index of the palette
    int width = 0;           ///< of the stroke, in 1/16 px
    Cap cap = Cap::butt;
    Join join = Join::miter;
};

/// One key of an object, and the way from it to the next.
struct Key {
    Time time;
    VelocityLaw law_x = VelocityLaw::constant;
    VelocityLaw law_y = VelocityLaw::constant;
    std::uint32_t curve_pieces = 1; ///< straight pieces that stand for a curve
    std::uint32_t drawing = 0;      ///< offset in the section of drawings
};

/// `drawings` is the section of drawings of the scene that the key belongs to.
PackedDrawing drawing_at(std::span<const std::byte> drawings, const Key& key);

/// Reads the keys of an object in the order of their times.
class KeyCursor {
public:
    explicit KeyCursor(ByteReader bytes) : bytes_{bytes} {}

    bool at_end() const { return bytes_.left() == 0; }
    /// Only when not at the end.
    Key next();
    bool overrun() const { return bytes_.overrun(); }

private:
    ByteReader bytes_;
    std::int32_t time_ = 0;
};

/// The two keys around a moment; the same key twice before the first and from the last one on.
struct KeyInterval {
    Key from;
    Key to;
};

/// One object of a scene; borrows the scene's bytes.
struct ObjectView {
    ObjectStyle style;
    KeyCursor keys;

    KeyInterval interval_at(Time time) const;
};

/// Reads the objects of a scene, the lowest first.
class ObjectCursor {
public:
    ObjectCursor(ByteReader bytes, std::uint32_t count) : bytes_{bytes}, left_{count} {}

    bool at_end() const { return left_ == 0; }
    /// Only when not at the end.
    ObjectView next();
    bool overrun() const { return bytes_.overrun(); }
    /// Bytes of the section that have not been read.
    std::size_t bytes_left() const { return bytes_.left(); }

private:
    ByteReader bytes_;
    std::uint32_t left_;
};

}
