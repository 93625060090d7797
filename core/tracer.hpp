#pragma once

#include "core/bytes/function_ref.hpp"
#include "core/math/projection.hpp"
#include "core/pose/item_state.hpp"
#include "core/pose/object_strokes.hpp"
#include "core/pose/scene_state.hpp"
#include "core/raster/outline/object_outline.hpp"
#include "core/raster/outline/picture.hpp"
#include "core/raster/outline/stroke_outline.hpp"
#include "core/scene_walk.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace kfast {

/// The outlines of everything visible in a scene at the time to which it was moved, in the order of
/// painting.
class Tracer {
public:
    /// The bones of the scene must have been posed.
    Tracer(const SceneOnPanel& scene, raster::Picture& picture) : on_panel_{scene}, picture_{picture} {}

    /// Reuses the layers whose outlines have not changed since the last picture. Curves are coarser if the
    /// picture finds no room otherwise.
    void run();

    // Called for features (core/features.hpp).

    /// Adds strokes, placed by a map, to an outline.
    using TraceStrokes = FunctionRef<void(const Affine&, ObjectOutline&)>;

    [[gnu::cold, gnu::noinline]] void trace_wires(const ObjectStrokes& strokes, SceneWalk& walk);
    void trace_drawing(SceneWalk& walk);
    void trace_label(SceneWalk& walk);
    /// trace(placement, outline) adds what is painted to an outline.
    void add_layers_in_depth(SceneWalk& walk, FunctionRef<Point()> first_point, TraceStrokes trace);

private:
    /// The parts of an item, each a layer.
    enum class Part : std::uint8_t { fill, stroke };

    static constexpr std::uint8_t coarsest = 8;

    void trace_scene();
    void trace_leaf(SceneWalk& walk);
    void trace_object(SceneWalk& walk);
    void trace_live(SceneWalk& walk);
    std::optional<RigidPlacement> rigid_placement(const Affine& deformer, const Space& space) const;
    void trace_rigid(const ObjectStrokes& strokes, const Pen* pen, const RigidPlacement& placement,
                     bool moves);
    bool reuse_layers(const SceneWalk& walk);
    void add_layers(SceneWalk& walk, FunctionRef<Point()> first_point, TraceStrokes trace);
    void add_layers(SceneWalk& walk, const ViewProjection& view, const Affine& placement,
                    FunctionRef<std::int32_t()> scale_factor, TraceStrokes trace);
    const StrokeFeature& pens() const { return *on_panel_.scene.features().strokes; }
    void add_live_layers(SceneWalk& walk, FunctionRef<Point()> first_point, TraceStrokes trace);
    void add_rigid_layers(SceneWalk& walk, const RigidPlacement& placement,
                          FunctionRef<void(const Pen*)> trace);
    void trace_upright(const RigidPlacement& placement, const Pen* pen, TraceStrokes trace);
    [[gnu::noinline]] void add_layer(Part part, const SceneWalk& walk, FunctionRef<void()> trace);

    const SceneOnPanel& on_panel_;
    raster::Picture& picture_;
};

}
