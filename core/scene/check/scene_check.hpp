#pragma once

#include "core/bytes/result.hpp"
#include "core/features.hpp"
#include "core/scene/check/picture_cost.hpp"
#include "core/scene/input_view.hpp"
#include "core/scene/kfb_limits.hpp"
#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace kfast {

/// How much more SceneView::parse() reads: keys and points of drawings. A scene says in few bytes that many
/// keys have the same drawing, or that many tracks have the same key times, and parsing reads them
/// for each; so a bound on the bytes alone would not bound the time.
class ReadAllowance {
public:
    explicit constexpr ReadAllowance(std::size_t scene_bytes)
        : left_{for_any_scene + per_byte * static_cast<std::uint32_t>(scene_bytes)}
    {
    }

    /// Whether that many may be read; then they count as read.
    constexpr bool take(std::uint32_t keys_or_points)
    {
        if (keys_or_points > left_)
            return false;
        left_ -= keys_or_points;
        return true;
    }

private:
    static constexpr std::uint32_t for_any_scene = 1U << 18;
    static constexpr std::uint32_t per_byte = 2; ///< drawings and keys as the compiler writes them need less

    std::uint32_t left_;
};

/// Whether the scene may have a key at this time.
inline bool is_key_moment(const SceneView& scene, Driver driver, Time time)
{
    if (driver.is_input())
        return (scene.number_inputs() >> driver.index() & 1U) != 0 && time <= whole_input;
    return time.ticks <= kfb::max_time && (driver.is_time() || driver.index() < scene.clock_count());
}

/// Checks everything that can be wrong within the sections of a scene, and counts what it needs.
class SceneCheck {
public:
    /// `scene` has its header and sections; `symbols` is room for the results of as many as it has.
    SceneCheck(SceneView& scene, std::span<ItemTotals> symbols)
        : scene_{scene}, allowance_{scene.size()}, parts_{scene.length()}, symbols_{symbols}
    {
    }

    /// Whether nothing is wrong; then the scene has the needs of its pictures.
    bool passes();
    /// The reason if not.
    Error error() const { return error_; }
    /// The item at fault, as SceneView::parse() returns it.
    std::uint32_t item() const { return item_; }

    // Called for features (core/features.hpp).

    /// Checks the skin of a key whose drawing has been checked, and whose skeleton has `bones` bones.
    bool check_skin(const Key& key, std::uint32_t bones);
    bool check_backbones(const BackbonesView& backbones);
    /// Checks the depths of a key whose drawing has been checked.
    bool check_depths(const Key& key);
    bool check_path(const ItemView& item);
    /// Checks the label of an item that shows the input `text`.
    bool check_label(const LabelView& label, const InputView& input);
    /// Checks that it has only lines, and no more than the input may have.
    bool check_default(const DrawingInput& input);

private:
    /// A drawing that was checked recently.
    struct CheckedDrawing {
        std::uint32_t key = 0; ///< its offset and 1
        std::uint32_t points = 0;
    };

    /// What the tracks of an item determine.
    struct Tracks {
        std::uint32_t seen = SceneParts::all; ///< the parts of the scene in which it may be visible
        std::uint8_t count = 0;
        bool may_be_transparent = false;
        bool has_order = false;
        bool is_placed = false;
    };

    /// A list of items, and the tracks of the group that they are in.
    struct Level {
        ItemCursor items{ByteReader{{}}};
        Tracks tracks{};
        ItemTotals totals{};
        std::uint32_t count = 0;
        std::uint16_t ordered = 0; ///< those that have an order

        void add(ItemTotals item, const Tracks& of_item);
    };

    bool needs(Feature feature);
    bool may_read(std::uint32_t keys_or_points);
    bool check_header() const;
    bool check_laws();
    bool check_inputs();
    bool check_clocks() const;
    bool check_clips() const;
    bool check_events() const;
    bool check_bones();
    bool check_symbols();
    bool check_whole();

    bool check_items(ItemCursor items, std::uint32_t usable_symbols, std::uint32_t depth, ItemTotals& totals);
    bool check_item(const ItemView& item, Level& level, Tracks& tracks);
    bool check_content(const ItemView& item, std::uint32_t seen, std::uint32_t usable_symbols,
                       ItemTotals& own);
    bool end_list(const Level& level);
    bool check_leaf(const ItemView& item, std::uint32_t seen);
    void add_cost(std::uint32_t cost, std::uint32_t seen);
    bool check_tracks(const ItemView& item, Tracks& tracks);
    bool check_track(const TrackView& track, const ObjectStyle& style);
    bool check_cut(const ItemView& item, const TrackView& track);
    bool check_value(const TrackView& track, std::int32_t value) const;
    std::uint32_t seen_by(const TrackView& track) const;
    bool is_hold(std::uint32_t laws) const { return (holds_[laws / 32] >> laws % 32 & 1U) != 0; }

    bool check_live(const ItemView& item);
    std::optional<InputView> input_at(std::uint32_t number) const;
    bool check_object(const ObjectView& object);
    bool check_style(const ObjectStyle& style);
    bool check_keys(const ObjectView& object);
    bool check_drawing(std::uint32_t offset);
    bool check_points(std::uint32_t offset, CheckedDrawing& checked);
    bool check_drawings(const ObjectView& object, const Key& key, std::uint32_t bones);
    bool check_deformer(const ObjectView& object);
    bool is_moment(Driver driver, Time time) const { return is_key_moment(scene_, driver, time); }
    bool is_law(std::uint32_t number) const { return number <= scene_.law_count_; }

    SceneView& scene_;
    Error error_ = Error::bad_scene;
    ReadAllowance allowance_;
    SceneParts parts_;
    std::array<std::uint32_t, 8> holds_{}; ///< a bit for each pair of laws that is hold
    std::span<ItemTotals> symbols_;
    std::array<CheckedDrawing, 32> checked_{}; ///< indexed by the lowest bits of their offsets
    // About the current symbol, or about the scene.
    PictureCost cost_;
    std::uint32_t shown_ = 0; ///< the parts in which it costs more than a thousand for each item
    // About the current item.
    std::uint32_t items_read_ = 0;
    std::uint32_t points_ = 0;         ///< of its largest drawing, or of all of its letters
    std::uint32_t strokes_ = 0;        ///< of the drawing that has most of them, or of all letters
    std::uint32_t drawing_points_ = 0; ///< of the drawing checked last
    // About the item that costs most.
    std::uint32_t max_ = 0;
    std::uint32_t item_ = 0xFFFF'FFFF;
};

/// Whether nothing is wrong with the scene's skeletons of bones; `laws` pairs of laws are stored.
bool are_bones_valid(const SceneView& scene, std::uint32_t laws, ReadAllowance& allowance);

/// Whether the inputs of the scene, which has its sections, are what the format allows, except for the
/// drawings that they refer to.
bool are_inputs_valid(const SceneView& scene);

/// Whether a label of this input is what the format allows, except for the drawings that it refers to.
bool is_label_valid(const LabelView& label, const InputView& input);

// About drawings that have been checked, at offsets in a scene's section of drawings:

/// Whether they have equally many strokes, with equally many segments of the same kinds.
bool is_built_alike(std::span<const std::byte> drawings, std::uint32_t one, std::uint32_t other);

bool has_only_lines(std::span<const std::byte> drawings, std::uint32_t offset);

/// Whether it has three strokes of lines for each backbone, with equally many points, at least two.
bool are_backbones(std::span<const std::byte> drawings, std::uint32_t offset);

}
