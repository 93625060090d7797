#pragma once

#include "core/beam/beam_lines.hpp"
#include "core/beam/beam_pen.hpp"
#include "core/item_state.hpp"
#include "core/item_view.hpp"
#include "core/moment.hpp"
#include "core/object_strokes.hpp"
#include "core/scene_on_panel.hpp"
#include "core/space.hpp"
#include "core/still.hpp"

#include <cstdint>

namespace kfast {

/// Evaluates a scene at a moment: the lit lines of all that is to be seen, in the order of painting. The
/// panel stands for the field, and its side has as many pixels as the profile's resolution.
class BeamTracer {
public:
    BeamTracer(const SceneOnPanel& scene, const Moment& moment, int resolution, BeamLines& lines)
        : on_panel_{scene}, moment_{moment}, resolution_{resolution}, lines_{lines}
    {
    }

    /// With coarser curves if the lines find no room otherwise.
    void run();
    /// How long the picture stays as it is.
    const Still& still() const { return still_; }
    /// Of so many objects the hatching had to be wider than told, to find room.
    std::uint32_t wider_hatchings() const { return wider_hatchings_; }

private:
    /// Where an item lies and what holds for it from outside.
    struct Context {
        Space space;
        std::uint32_t path = 0;      ///< tells the item apart
        std::uint32_t opacity = 255; ///< of it and all around it
    };

    static constexpr int coarsest = 8;

    void trace_scene();
    void trace(ItemCursor items, const Context& context);
    void trace(const ItemView& item, const Context& outer);
    void trace_object(const ItemView& item, const ItemState& state, const Context& context);
    void trace_wires(const ItemView& item, const ObjectStrokes& strokes, const ItemState& state,
                     const Context& context);
    void trace_live(const ItemView& item, const ItemState& state, const Context& context);
    template <class Trace>
    void add_lines(const ItemView& item, const ItemState& state, const Context& context, Trace trace);
    template <class Trace>
    void add_hatching(const ItemView& item, Colour colour, const Context& context, Trace trace);
    template <class DrawWith>
    void draw(BeamInk ink, Colour colour, const Context& context, DrawWith draw_with);

    const SceneOnPanel& on_panel_;
    Moment moment_;
    int resolution_;
    BeamLines& lines_;
    Still still_;
    int coarseness_ = 0;
    std::uint32_t wider_hatchings_ = 0;
};

}
