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
    PreparedScene prepared{};  ///< at the time of the picture
    Space canvas;              ///< from the canvas to the panel
    std::span<Space> spaces{}; ///< room for those of placed items in each other, for one walk at a time
    Camera camera;
    RigidPlacements rigid;
    std::span<PosedBone> bones{}; ///< of all skeletons; set up
    std::span<BackboneNode> backbone_nodes{};
    InputDrawings drawings{};       ///< from outside
    InputTexts texts{};             ///< from outside
    std::span<const Time> inputs{}; ///< the place of each input; one that is not set is at 0
};

/// What a live item of these pictures shows, a label.
LabelTrace label_of(const SceneOnPanel& on_panel, const LiveView& live);

/// Makes it without anything that moves. `fit` places the canvas on the panel; the viewer is in front of
/// its middle.
SceneOnPanel on_panel(const SceneView& scene, Size panel, Fit fit);

/// A scene on one panel, and what comes to it from outside: what all that plays scenes has in common.
class SceneState {
public:
    /// Puts the input `number` of the scene, less than input_count(), at `place`, which is clamped to
    /// 0 … whole_input (InputView::place_of). Until then inputs have their default values.
    void set_input(std::uint32_t number, Time place);
    Time input(std::uint32_t number) const
    {
        expects(number < inputs_.size());
        return inputs_[number];
    }
    /// Sets the input `number` of the scene, less than input_count(), to `text`, in UTF-8. Characters that
    /// have no glyph are left out, and so are those beyond the maximum length. Until then inputs have their
    /// default texts. An input that is no text stays as it is.
    void set_text(std::uint32_t number, std::string_view text);
    /// The glyphs of the input `number` of the scene, a text, by their numbers.
    std::span<const std::byte> text(std::uint32_t number) const
    {
        return on_panel_.texts.glyphs(scene(), number);
    }
    /// Sets the input `number` of the scene, a drawing, to `strokes`; strokes without points are skipped.
    /// Until then it is the default drawing. False, and nothing changes, if there is no room for them.
    bool set_drawing(std::uint32_t number, std::span<const InputStroke> strokes);
    /// Shows the next drawing of the input `number`, which has been added to drawing(number).
    void show_next_drawing(std::uint32_t number);
    /// For adding a drawing point by point. Only show_next_drawing() shows the next drawing.
    InputDrawing drawing(std::uint32_t number) const { return on_panel_.drawings.of(scene(), number); }

    const SceneView& scene() const { return on_panel_.scene; }

protected:
    /// Bytes of memory for what moves.
    static std::size_t bytes_for(const SceneView& scene);

    /// `memory`, aligned to 4 bytes, has bytes_for(scene). It and `scene`'s bytes must outlive this.
    SceneState(const SceneView& scene, Size panel, Fit fit, std::span<std::byte> memory);

    const SceneOnPanel& on_panel() const { return on_panel_; }
    /// Moves the prepared scene to a time. Returns what has moved since the previous time: keys, and inputs
    /// that were set.
    const Dependence& move_to(Time time);
    /// Poses the bones as at the time of the last move_to().
    void pose_bones();
    /// Calls move_to() and pose_bones(). What is returned is valid until an input is set or
    /// the time moved.
    SceneTime pose(Time time);

private:
    void mark_input_changed(std::uint32_t number);

    SceneOnPanel on_panel_;
    std::span<Time> inputs_;           ///< the place of each of them
    std::uint32_t changed_inputs_ = 0; ///< a bit for each input that was given a new value
};

}
