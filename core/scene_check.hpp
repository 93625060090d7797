#pragma once

#include "core/features.hpp"
#include "core/label_view.hpp"
#include "core/result.hpp"
#include "core/scene_view.hpp"

#include <cstdint>
#include <optional>

namespace kfast {

/// Looks for everything that can be wrong within the sections of a scene, and counts what it needs.
class SceneCheck {
public:
    /// `scene` has its header and sections.
    explicit SceneCheck(SceneView& scene) : scene_{scene} {}

    /// Whether nothing is wrong; then the scene knows its paint_steps() and blended_depth().
    bool passes();
    /// Why not.
    Error error() const { return error_; }

    // Called for features (core/feature_code.hpp).

    /// Of a key whose drawing has been checked, and whose skeleton has so many bones.
    bool check_skin(const Key& key, std::uint32_t bones);
    bool check_backbones(const BackbonesView& backbones);
    /// Of a key whose drawing has been checked.
    bool check_depths(const Key& key);
    bool check_path(const ItemView& item) const;
    /// Of an item that shows the input `text`.
    bool check_label(const LabelView& label, const TextInput& text);
    /// Lines, and no more than the input may have.
    bool check_usual(const DrawingInput& input);

private:
    bool needs(Feature feature);
    bool check_header() const;
    bool check_laws() const;
    bool check_inputs();
    bool check_clips() const;
    bool check_events() const;
    bool check_bones();
    bool check_symbols();
    bool check_items(ItemCursor items, std::uint32_t usable_symbols, std::uint32_t depth);
    bool check_item(const ItemView& item, std::uint32_t usable_symbols, std::uint32_t depth);
    bool check_tracks(const ItemView& item);
    bool check_track(const TrackView& track, const ObjectStyle& style);
    bool check_value(const TrackView& track, std::int32_t value) const;
    bool check_live(const ItemView& item);
    std::optional<InputView> input_at(std::uint32_t number) const;
    bool check_object(const ObjectView& object);
    bool check_style(const ObjectStyle& style);
    bool check_keys(const ObjectView& object);
    bool check_drawing(std::uint32_t offset);
    bool check_carrier(const ObjectView& object);
    bool is_moment(Clock clock, Time time) const;
    bool is_law(std::uint32_t number) const { return number <= scene_.law_count_; }

    /// How deep an item lies in others: of all kinds, blended as a whole, and placed.
    struct Depth {
        std::uint32_t all = 0;
        std::uint32_t blended = 0;
        std::uint32_t placed = 0;
    };

    bool count_items(ItemCursor items, const Depth& depth);
    bool count_item(const ItemView& item, Depth depth);
    bool count_records();

    SceneView& scene_;
    Error error_ = Error::bad_scene;
    std::uint32_t key_points_ = 0; ///< of the drawings of all keys
    std::uint32_t spaces_ = 0;     ///< the most that lie in each other
    std::uint32_t items_ = 0;      ///< those of a symbol counted wherever it is used
};

}
