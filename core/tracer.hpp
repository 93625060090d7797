#pragma once

#include "core/function_ref.hpp"
#include "core/item_state.hpp"
#include "core/key_interval.hpp"
#include "core/moment.hpp"
#include "core/object_outline.hpp"
#include "core/object_strokes.hpp"
#include "core/raster/picture.hpp"
#include "core/scene_on_panel.hpp"
#include "core/space.hpp"
#include "core/stroke_outline.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>

namespace kfast {

/// Evaluates a scene at a moment: the outlines of all that is to be seen, in the order of painting.
class Tracer {
public:
    Tracer(const SceneOnPanel& scene, const Moment& moment, raster::Picture& picture)
        : on_panel_{scene}, moment_{moment}, picture_{picture}
    {
    }

    /// Reuses the layers whose outlines have not changed since the last picture; `moved` has a bit for each
    /// input that has. Curves are coarser if the picture finds no room otherwise.
    void run(std::uint32_t moved);

private:
    /// Where an item lies and what holds for it from outside.
    struct Context {
        Space space;
        Still still = {};            ///< of all that holds for it
        std::uint32_t path = 0;      ///< tells the item apart
        std::uint32_t opacity = 255; ///< of items around a single layer
    };

    /// Adds strokes, placed by a map, to an outline.
    using TraceStrokes = FunctionRef<void(const Affine&, ObjectOutline&)>;

    /// Of an item, each a layer.
    enum class Part : std::uint8_t { fill, stroke };

    static constexpr std::uint8_t coarsest = 8;

    void trace_scene();
    Context holding(const Context& outer, const Still& still);
    void trace(ItemCursor items, const Context& context);
    void trace(const ItemView& item, const Context& context);
    void trace(const ItemView& item, const ItemState& state, const Context& context);
    void trace_live(const ItemView& item, const ItemState& state, const Context& context);
    void trace_drawing(const LiveDrawing& drawing, const ObjectStyle& style, const ItemState& state,
                       const Context& context);
    void trace_label(const ItemView& item, const ItemState& state, const Context& context);
    std::optional<RigidPlacement> rigid_placement(const Affine& carrier, const Context& context) const;
    void trace_rigid(const ObjectStrokes& strokes, const Pen* pen, const RigidPlacement& placement,
                     bool moves);
    bool moves(const Still& still) const;
    void trace_object(const ObjectView& object, const ItemState& state, const Context& context);
    [[gnu::cold, gnu::noinline]] void trace_wires(const ObjectStrokes& strokes, const ObjectStyle& style,
                                                  const ItemState& state, const Context& context);
    raster::PaintStep& add_step(raster::PaintStep::Kind kind, const Context& context);
    void add_layers(const ObjectStyle& style, const ItemState& state, const Context& context,
                    FunctionRef<Point()> first_point, TraceStrokes trace);
    void add_live_layers(const ObjectStyle& style, const ItemState& state, const Context& context,
                         FunctionRef<Point()> first_point, TraceStrokes trace);
    void add_rigid_layers(const ObjectStyle& style, const ItemState& state, const RigidPlacement& placement,
                          const Context& context, FunctionRef<void(const Pen*)> trace);
    void trace_upright(const RigidPlacement& placement, const Pen* pen, TraceStrokes trace);
    [[gnu::noinline]] void add_layer(Part part, Colour colour, FillRule rule, const Context& context,
                                     FunctionRef<void()> trace);

    const SceneOnPanel& on_panel_;
    Moment moment_;
    raster::Picture& picture_;
};

}
