#pragma once

#include "core/bytes/byte_reader.hpp"
#include "core/bytes/result.hpp"
#include "core/features.hpp"
#include "core/math/point.hpp"
#include "core/pixel/paint_style.hpp"
#include "core/scene/format.hpp"
#include "core/scene/input_view.hpp"
#include "core/scene/item_view.hpp"
#include "core/scene/kfb_limits.hpp"
#include "core/scene/packed_drawing.hpp"
#include "core/scene/skeleton_view.hpp"
#include "core/time/clock.hpp"
#include "core/time/time.hpp"
#include "core/time/velocity_law.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace kfast {

/// A named part of the time; borrows the scene's bytes.
struct ClipView {
    std::string_view name; ///< UTF-8
    Time begin;
    Time end; ///< later than `begin`
    Loop loop = Loop::once;
};

/// A named time; borrows the scene's bytes.
struct EventView {
    std::string_view name; ///< UTF-8
    Time time;
};

/// Reads the clocks of a scene in their order.
class ClockCursor {
public:
    ClockCursor(ByteReader bytes, std::uint32_t count) : bytes_{bytes}, left_{count} {}

    bool at_end() const { return left_ == 0; }
    /// Only when not at the end.
    Clock next();
    /// What has not been read: the clips, after the last clock.
    const ByteReader& rest() const { return bytes_; }

private:
    ByteReader bytes_;
    std::uint32_t left_;
};

/// Reads the clips of a scene in their order.
class ClipCursor {
public:
    ClipCursor(ByteReader bytes, std::uint32_t count) : bytes_{bytes}, left_{count} {}

    bool at_end() const { return left_ == 0; }
    /// Only when not at the end.
    ClipView next();
    /// What has not been read: the events, after the last clip.
    const ByteReader& rest() const { return bytes_; }

private:
    ByteReader bytes_;
    std::uint32_t left_;
};

/// Reads the events of a scene in the order of their times.
class EventCursor {
public:
    explicit EventCursor(ByteReader bytes) : bytes_{bytes} {}

    bool at_end() const { return bytes_.left() == 0; }
    /// Only when not at the end.
    EventView next();
    bool overrun() const { return bytes_.overrun(); }

private:
    ByteReader bytes_;
    Time time_;
};

/// The distance of the viewer if a scene does not set one, in pixels: twice the longer side. From there the
/// canvas is seen within 28 degrees.
constexpr std::int32_t default_camera(Size canvas)
{
    return std::max<std::int32_t>(kfb::min_camera, 2 * std::max(canvas.width, canvas.height));
}

struct ItemTotals;

/// What a scene needs that is prepared to be played (core/prepared/prepared_scene.hpp).
struct SceneRecords {
    std::uint32_t timelines = 0; ///< sets of two or more key times that are stored
    std::uint32_t tracks = 0;    ///< of items, of the keys of objects, of bones
    std::uint32_t nodes = 0;     ///< items as they are stored, symbols, and the scene
    std::uint32_t bones = 0;     ///< of all skeletons
    std::uint32_t spaces = 0;    ///< of nested items that are placed
    std::uint32_t levels = 0;    ///< nested items, and the scene
};

/// A checked, borrowed view of the bytes of a compiled scene (docs/format.md).
///
/// Everything that can be wrong with the bytes is found by parse(). Every other member is total: it cannot
/// fail and does not check again.
class SceneView {
    struct Unread {
        explicit Unread() = default;
    };

public:
    /// Only for parse().
    explicit SceneView(Unread) {}

    /// `bytes` must outlive the view; more bytes than the scene has are ignored. `features` are those that
    /// the program has to play it with. Fails with truncated, bad_magic, unsupported_version, bad_checksum,
    /// bad_scene, too_slow, or with the first feature that the scene needs and the program does not have.
    /// After too_slow `item`, if not null, is the number of the item that costs most, a use with all that is
    /// inside, in the order in which they are stored; after bad_scene, if the scene has more keys and points
    /// than are read (core/scene/check/scene_check.hpp), that of the item at which it was too much;
    /// 0xFFFFFFFF if it is none.
    static Result<SceneView> parse(std::span<const std::byte> bytes, const Features& features = every_feature,
                                   std::uint32_t* item = nullptr);

    /// The code that plays it.
    const Features& features() const { return features_; }
    /// The part of it that the scene needs.
    FeatureSet needed_features() const { return needed_features_; }

    /// The bytes of the scene itself.
    std::size_t size() const { return size_; }
    Size canvas() const { return canvas_; }
    /// Distance of the viewer from the canvas, in pixels.
    std::int32_t camera() const { return camera_; }
    /// Frames in 1000 seconds: 30 fps is 30000.
    std::uint32_t frame_rate() const { return frame_rate_; }
    /// At least one frame.
    Time length() const { return length_; }
    Loop loop() const { return loop_; }
    /// Memory for the outlines of one picture at its fullest; a multiple of 4.
    std::uint32_t outline_bytes() const { return outline_bytes_; }
    /// The maximum number of borders of a picture, those in each band of four rows counted, on a panel as
    /// large as the canvas: the record of what the panel shows has room for them.
    std::uint32_t borders() const { return borders_; }
    /// Memory for what is kept from picture to picture; a multiple of 4: contours of drawings that move as a
    /// whole, and pairs of drawings made equal. Too little costs only time.
    std::uint32_t cache_bytes() const { return cache_bytes_; }
    /// The maximum number of steps to paint a row: one for each fill and each stroke, and two for each item
    /// that may be blended as a whole. What is in a symbol counts wherever it is used.
    std::uint32_t paint_steps() const { return paint_steps_; }
    /// The least that its worst picture costs, in thousands of instructions of a Cortex-M0 (PictureCost),
    /// without most of the painting of pixels.
    std::uint32_t cost() const { return cost_; }
    /// How deep items that may be blended as a whole are nested.
    std::uint32_t blended_depth() const { return blended_depth_; }

    /// `index` is less than palette_size(); 0 is the background.
    Colour colour(std::size_t index) const;
    std::size_t palette_size() const { return palette_.size() / colour_bytes_; }
    /// `number` is that of a key.
    LawPair laws(std::uint32_t number) const;
    /// Where the pair of that number is stored, for laws_at(), which reads it without going through all that
    /// come before it.
    std::uint16_t place_of_laws(std::uint32_t number) const;
    LawPair laws_at(std::uint16_t place) const;
    /// The skeletons of bones.
    SkeletonCursor skeletons() const { return SkeletonCursor{bones_}; }
    const SceneRecords& records() const { return records_; }
    /// The bones of all skeletons together.
    std::uint32_t bone_count() const { return records_.bones; }
    /// The number of bones of the skeletons before `skeleton`.
    std::size_t first_bone(std::uint32_t skeleton) const;
    /// The maximum number of nodes and gaps of the backbones of an object (core/pose/posed_backbones.hpp).
    std::size_t backbone_nodes() const { return backbone_nodes_; }
    /// The outermost items.
    ItemCursor items() const { return ItemCursor{items_}; }
    /// `number` is less than symbol_count().
    ItemCursor symbol(std::uint32_t number) const;
    /// The items in a group or in the symbol that is used; not for a leaf.
    ItemCursor items_in(const ItemView& item) const;
    std::uint32_t symbol_count() const { return symbol_count_; }
    /// `offset` is that of a key.
    PackedDrawing drawing(std::uint32_t offset) const { return drawing_at(drawings_, offset); }
    /// `skin` is that of a key: an offset in the section of drawings, or, if it is negative, the bone -1 -
    /// skin.
    SkinReader skin(std::int32_t skin) const;
    static constexpr std::uint32_t bone_of(std::int32_t skin)
    {
        return static_cast<std::uint32_t>(kfb::skin::of_bone(skin));
    }
    /// All drawings, to which the offsets of keys refer.
    std::span<const std::byte> drawings() const { return drawings_; }
    /// A position in the scene's bytes as a number: its distance from their end.
    std::uint32_t place_of(const std::byte* byte) const
    {
        return static_cast<std::uint32_t>(drawings_.data() + drawings_.size() - byte);
    }
    /// The bytes from there on.
    ByteReader at(std::uint32_t place) const
    {
        return ByteReader{{drawings_.data() + drawings_.size() - place, place}};
    }
    /// What the scene takes from outside.
    InputCursor inputs() const { return {inputs_, input_count_}; }
    std::uint32_t input_count() const { return input_count_; }
    /// `number` is less than input_count().
    InputView input(std::uint32_t number) const;
    /// A bit for each input that is a number, the first in the lowest: keys may go by it.
    std::uint32_t number_inputs() const { return number_inputs_; }
    /// The number of the input that has this name.
    std::optional<std::uint32_t> input(std::string_view name) const;
    /// The times of their own that parts of the scene go by.
    ClockCursor clocks() const { return {clocks_, clock_count_}; }
    std::uint32_t clock_count() const { return clock_count_; }
    ClipCursor clips() const;
    std::optional<ClipView> clip(std::string_view name) const;
    /// The events in the order of their times.
    EventCursor events() const;

private:
    friend class SceneCheck;

    std::optional<Error> read(std::span<const std::byte> bytes, std::uint32_t* item);
    bool read_sections(ByteReader reader);
    void read_marks(ByteReader marks);
    std::optional<Error> check(std::uint32_t* item);
    std::optional<Error> check(std::uint32_t* item, std::span<ItemTotals> symbols);
    template <std::size_t symbols>
    std::optional<Error> check_in_room(std::uint32_t* item);
    bool count_records();

    Features features_;
    std::size_t size_ = 0;
    Size canvas_;
    std::int32_t camera_ = 0;
    std::uint32_t frame_rate_ = 0;
    Time length_;
    Loop loop_ = Loop::repeat;
    std::uint32_t outline_bytes_ = 0;
    std::uint32_t borders_ = 0;
    std::uint32_t cache_bytes_ = 0;
    std::uint32_t paint_steps_ = 0;
    std::uint32_t blended_depth_ = 0;
    SceneRecords records_;
    std::size_t backbone_nodes_ = 0;
    std::uint32_t law_count_ = 0;
    std::uint32_t symbol_count_ = 0;
    std::uint32_t input_count_ = 0;
    std::uint32_t clock_count_ = 0;
    std::uint32_t number_inputs_ = 0;
    FeatureSet needed_features_;
    std::uint16_t cost_ = 0;
    std::size_t colour_bytes_ = 3; ///< 4 if they have opacities
    std::span<const std::byte> palette_;
    ByteReader laws_;
    ByteReader inputs_;
    ByteReader clocks_;
    ByteReader marks_; ///< behind the clocks
    ByteReader bones_;
    ByteReader symbols_;
    ByteReader items_;
    std::span<const std::byte> drawings_;
};

/// A part of a scene's time that is played, and what happens at its ends.
struct PlayRange {
    Time begin;
    Time end; ///< later than `begin`; both are within 0 … kfb::max_time
    Loop loop = Loop::repeat;

    constexpr Time length() const { return end - begin; }
};

/// The whole scene.
inline PlayRange play_range_of(const SceneView& scene) { return {Time{0}, scene.length(), scene.loop()}; }

constexpr PlayRange play_range_of(const ClipView& clip) { return {clip.begin, clip.end, clip.loop}; }

}
