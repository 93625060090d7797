#pragma once

#include "core/bytes/expects.hpp"
#include "core/math/affine.hpp"
#include "core/math/point.hpp"
#include "core/math/projection.hpp"
#include "core/pose/input_drawing.hpp"
#include "core/pose/item_state.hpp"
#include "core/pose/label_layout.hpp"
#include "core/pose/posed_backbones.hpp"
#include "core/pose/posed_bones.hpp"
#include "core/prepared/prepared_scene.hpp"
#include "core/scene/scene_view.hpp"
#include "core/time/time.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace kfast {

/// What the pictures of a scene on one panel have in common.
struct SceneOnPanel {
    SceneView scene;
    PreparedScene prepared{};  ///< at the moment of the picture
    Space canvas;              ///< from the canvas to the panel
    std::span<Space> spaces{}; ///< room for those of placed items in each other, for one walk at a time
    Camera camera;
    RigidPlacements rigid;
    std::span<PosedBone> bones{}; ///< of all skeletons; set up
    std::span<BackboneNode> backbone_nodes{};
    InputDrawings drawings{}; ///< from outside
    InputTexts texts{};       ///< likewise
};

/// Without anything that moves. The canvas lies on the panel as `fit` wants it, and the viewer in front of
/// its middle.
SceneOnPanel on_panel(const SceneView& scene, Size panel, Fit fit);

/// A scene on one panel, and what comes to it from outside: what all that plays scenes has in common.
class SceneState {
public:
    /// From now on the input `number` of the scene, less than input_count(), stands at `place`, which is held
    /// within 0 … whole_input (InputView::place_of). At first inputs stand at their default values.
    void set_input(std::uint32_t number, Time place);
    Time input(std::uint32_t number) const
    {
        expects(number < inputs_.size());
        return inputs_[number];
    }
    /// From now on the input `number` of the scene, less than input_count(), is `text`, in UTF-8. Characters
    /// that have no glyph are left out, and so are those beyond the most that the input takes. At first
    /// inputs have their default texts. One that is no text stays as it is.
    void set_text(std::uint32_t number, std::string_view text);
    /// The glyphs of the input `number` of the scene, a text, by their numbers.
    std::span<const std::byte> text(std::uint32_t number) const
    {
        return on_panel_.texts.glyphs(scene(), number);
    }
    /// From now on the input `number` of the scene, a drawing, is `strokes`, of which none without points
    /// counts; at first it is the default one. Whether there is room for them; if not, nothing changes.
    bool set_drawing(std::uint32_t number, std::span<const InputStroke> strokes);
    /// Likewise what has come to drawing(number).
    void show_next_drawing(std::uint32_t number);
    /// For telling a drawing point by point. What is next is shown by show_next_drawing() alone.
    InputDrawing drawing(std::uint32_t number) const { return on_panel_.drawings.of(scene(), number); }

    const SceneView& scene() const { return on_panel_.scene; }

protected:
    /// Bytes of memory for what moves.
    static std::size_t bytes_for(const SceneView& scene);

    /// `memory`, aligned to 4 bytes, has bytes_for(scene). It and `scene`'s bytes must outlive this.
    SceneState(const SceneView& scene, Size panel, Fit fit, std::span<std::byte> memory);

    const SceneOnPanel& on_panel() const { return on_panel_; }
    /// Moves the prepared scene to a moment, and tells what has moved since the one before: keys, and what
    /// was told.
    const Dependence& move_to(Time time);
    /// As at that moment.
    void pose_bones();
    /// Both. What is returned holds until an input is set.
    SceneTime pose(Time time);

private:
    void mark_input_changed(std::uint32_t number);

    SceneOnPanel on_panel_;
    std::span<Time> inputs_;           ///< where each of them stands
    std::uint32_t changed_inputs_ = 0; ///< a bit for each input that was given a new value
};

}
