#pragma once

#include "core/item_state.hpp"
#include "core/item_view.hpp"
#include "core/moment.hpp"
#include "core/object_strokes.hpp"
#include "core/scene_on_panel.hpp"
#include "core/space.hpp"

#include <cstdint>
#include <string>

namespace kfast {

/// Evaluates a scene at a moment: all that is to be seen as elements of an SVG, in the order of painting.
/// What Tracer makes layers and blends of, it makes paths and groups of.
class SvgTracer {
public:
    SvgTracer(const SceneOnPanel& scene, const Moment& moment) : on_panel_{scene}, moment_{moment} {}

    std::string run();

private:
    /// Where an item lies and what holds for it from outside.
    struct Context {
        Space space;
        std::uint32_t opacity = 255; ///< of items around a single layer
    };

    void trace(ItemCursor items, const Context& context);
    void trace(const ItemView& item, const Context& outer);
    void trace(const ItemView& item, const ItemState& state, const Context& context);
    void trace_object(const ObjectView& object, const ItemState& state, const Context& context);
    void trace_wires(const ObjectStrokes& strokes, const ObjectStyle& style, const ItemState& state,
                     const Context& context);
    void trace_live(const ItemView& item, const ItemState& state, const Context& context);
    template <class Trace>
    void add_paths(const ObjectStyle& style, const ItemState& state, const Context& context, Point first,
                   Trace trace);
    void add_path(const std::string& data, const std::string& look);

    const SceneOnPanel& on_panel_;
    Moment moment_;
    std::string elements_;
};

}
