#pragma once

#include "core/label_view.hpp"
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

private:
    bool check_header() const;
    bool check_laws() const;
    bool check_inputs();
    bool check_usual(const DrawingInput& input);
    bool check_clips() const;
    bool check_events() const;
    bool check_bones();
    bool check_symbols();
    bool check_items(ItemCursor items, std::uint32_t usable_symbols, std::uint32_t depth);
    bool check_item(const ItemView& item, std::uint32_t usable_symbols, std::uint32_t depth);
    bool check_tracks(const ItemView& item) const;
    bool check_track(const TrackView& track, const ObjectStyle& style) const;
    bool check_value(const TrackView& track, std::int32_t value) const;
    bool check_live(const ItemView& item);
    bool check_label(const LabelView& label, const TextInput& text);
    std::optional<InputView> input_at(std::uint32_t number) const;
    bool check_object(const ObjectView& object);
    bool check_style(const ObjectStyle& style) const;
    bool check_keys(const ObjectView& object);
    bool check_drawing(std::uint32_t offset);
    bool check_path(const ItemView& item) const;
    bool check_carrier(const ObjectView& object);
    bool check_backbones(const BackbonesView& backbones);
    bool check_depths(const Key& key);
    bool check_skin(const Key& key, std::uint32_t bones);
    bool is_moment(Clock clock, Time time) const;
    bool is_law(std::uint32_t number) const { return number <= scene_.law_count_; }

    bool count_items(ItemCursor items, std::uint32_t depth, std::uint32_t blended);
    bool count_item(const ItemView& item, std::uint32_t depth, std::uint32_t blended);
    bool count_records();

    SceneView& scene_;
    std::uint32_t key_points_ = 0; ///< of the drawings of all keys
    std::uint32_t items_ = 0;      ///< those of a symbol counted wherever it is used
};

}
