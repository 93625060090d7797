#pragma once

#include "core/pose/object_strokes.hpp"
#include "core/pose/scene_state.hpp"
#include "core/scene_walk.hpp"

#include <string>

namespace kfast {

/// All that is to be seen of a scene at the moment to which it was moved, as elements of an SVG, in the order
/// of painting. What Tracer makes layers and blends of, it makes paths and groups of.
class SvgTracer {
public:
    /// The bones of the scene have been posed.
    explicit SvgTracer(const SceneOnPanel& scene) : on_panel_{scene} {}

    std::string run();

private:
    void trace_leaf(SceneWalk& walk);
    void trace_object(SceneWalk& walk);
    void trace_wires(SceneWalk& walk, const ObjectStrokes& strokes);
    void trace_live(SceneWalk& walk);
    template <class Trace>
    void add_paths(SceneWalk& walk, Point first, Trace trace);
    void add_path(const std::string& data, const std::string& look);

    const SceneOnPanel& on_panel_;
    std::string elements_;
};

}
