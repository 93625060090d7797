#pragma once

#include "core/bytes/byte_reader.hpp"
#include "core/bytes/expects.hpp"
#include "core/pixel/paint_style.hpp"
#include "core/scene/packed_drawing.hpp"
#include "core/scene/skeleton_view.hpp"
#include "core/scene/track_view.hpp"
#include "core/time/time.hpp"
#include "core/time/track.hpp"

#include <cstdint>

namespace kfast {

/// Identifies an item, which is stored at `place` (SceneView::place_of), also where symbols are used; `outer`
/// is the path of the group or use that it is in, 0 for the outermost ones. Items of the same list begin at
/// different bytes, and a path leads through at most eight of them.
constexpr std::uint32_t path_to(std::uint32_t place, std::uint32_t outer)
{
    return (outer ^ place) * 0x9E37'79B1U + (outer >> 15);
}

/// How an object is painted: filled, stroked or both, the stroke over the fill.
struct ObjectStyle {
    bool is_filled = false;
    bool is_stroked = false;
    FillRule fill_rule = FillRule::nonzero;
    std::uint8_t fill = 0;   ///< index of the palette
    std::uint8_t stroke = 0; ///< index of the palette; it and the rest only of what is stroked
    Cap cap = Cap::butt;
    Join join = Join::miter;
    std::uint8_t miter_limit = default_miter_limit; ///< in 1/8 widths
    int width = 0;                                  ///< in 1/16 px
};

/// One key of an object, and the interval from it to the next.
struct Key {
    Time time;
    std::uint32_t laws = 0;    ///< number of the pair of laws
    std::uint32_t drawing = 0; ///< offset in the section of drawings
    std::uint32_t arrival = 0; ///< offset of what the interval leads to; only if the object has such drawings
    /// What belongs to the drawing: if bones deform the object, the skin (see SceneView::skin); of a wire
    /// frame the offset of the drawing of its depths.
    std::int32_t more = 0;
};

/// Reads the keys of an object in the order of their times.
class KeyCursor {
public:
    /// Reads the keys from `bytes`.
    KeyCursor(ByteReader& bytes, bool has_arrivals, bool has_more);

    bool at_end() const { return key_times_.at_end(); }
    /// Only when not at the end.
    Key next()
    {
        expects(!at_end());
        return at(key_times_.next());
    }
    /// What has not been read.
    const KeyTimeCursor& key_times() const { return key_times_; }
    const PackedValues& drawings() const { return drawings_; }
    const PackedValues& arrivals() const { return arrivals_; }
    const PackedValues& more() const { return more_; }
    Key at(const KeyTime& key_time) const;

private:
    KeyTimeCursor key_times_;
    PackedValues drawings_;
    PackedValues arrivals_;
    PackedValues more_;
    bool has_arrivals_;
    bool has_more_;
};

/// Skips the drawings in between.
inline KeyInterval<Key> interval_at(const KeyCursor& keys, Time time)
{
    const auto [from, to] = interval_at(keys.key_times(), time);
    return {keys.at(from), keys.at(to)};
}

/// What moves the points of an object besides its drawings.
enum class Deformer : std::uint8_t { none, backbones, bones };

/// What an object is besides its tracks; borrows the scene's bytes.
struct ObjectView {
    ObjectStyle style;
    Deformer deformer = Deformer::none;
    std::uint32_t skeleton = 0;   ///< number of the skeleton; only if bones deform the object
    BackbonesView backbones = {}; ///< only if backbones deform it
    bool has_arrivals = false;    ///< see Key::arrival
    bool has_depths = false;      ///< it is a wire frame; then nothing deforms it
    ByteReader key_bytes;         ///< begins with the keys

    /// Whether its keys have Key::more.
    bool has_more() const { return has_depths || deformer == Deformer::bones; }
    KeyCursor keys() const
    {
        ByteReader bytes = key_bytes;
        return take_keys(bytes);
    }
    /// Reads the keys, with which `bytes` begin.
    KeyCursor take_keys(ByteReader& bytes) const { return {bytes, has_arrivals, has_more()}; }
};

enum class ItemKind : std::uint8_t { object, group, use, live };

/// What a live item shows.
enum class InputLeaf : std::uint8_t {
    drawing, ///< an input of InputType::drawing, in the item's style
    label,   ///< one of InputType::text or InputType::number, in the item's style
};

/// What a live item is besides its tracks and its style.
struct LiveView {
    InputLeaf kind = InputLeaf::drawing;
    std::uint32_t input = 0; ///< its number in the scene
    ByteReader label{};      ///< how it is laid out, for LabelView; only of a label
};

/// Something that is painted; borrows the scene's bytes.
struct ItemView {
    ItemKind kind = ItemKind::object;
    bool is_known = false;            ///< no bit without a meaning is set
    const std::byte* place = nullptr; ///< where it begins in the scene's bytes
    TrackCursor tracks;
    BeamStyle beam{};         ///< only of an object and a live item
    PathView path;            ///< only if there is a track of Property::along
    ObjectView object;        ///< only of an object; the style also of a live item
    LiveView live{};          ///< only of a live item
    ByteReader items;         ///< inside; only of a group
    std::uint32_t symbol = 0; ///< only of a use

    /// Whether it is painted itself, instead of items inside of it.
    bool is_leaf() const { return kind == ItemKind::object || kind == ItemKind::live; }
    /// Whether some track moves, rotates or scales it.
    bool is_placed() const;
    /// Whether some track says that its strokes are drawn in part, or dashed.
    bool is_cut() const;
    /// How many dashes are drawn of its strokes at most; 0 if they are not dashed.
    std::uint32_t max_dashes() const;
};

/// Reads a list of items, the lowest first.
class ItemCursor {
public:
    explicit ItemCursor(ByteReader bytes) : bytes_{bytes} {}

    bool at_end() const { return bytes_.left() == 0; }
    /// Only when not at the end.
    ItemView next();
    bool overrun() const { return bytes_.overrun(); }

private:
    ByteReader bytes_;
};

}
