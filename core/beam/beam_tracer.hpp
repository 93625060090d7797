#pragma once

#include "core/beam/beam_lines.hpp"
#include "core/beam/beam_pen.hpp"
#include "core/pose/object_strokes.hpp"
#include "core/pose/scene_state.hpp"
#include "core/scene_walk.hpp"

#include <cstdint>

namespace kfast {

/// The lit lines of everything visible in a scene at the time to which it was moved, in the order of
/// painting. The panel represents the field, and its side has as many pixels as the profile's resolution.
class BeamTracer {
public:
    /// The bones of the scene must have been posed.
    BeamTracer(const SceneOnPanel& scene, int resolution, BeamLines& lines)
        : on_panel_{scene}, resolution_{resolution}, lines_{lines}
    {
    }

    /// Traces it, with coarser curves if the lines find no room otherwise.
    void run();
    /// What the picture depends on.
    const Dependence& dependence() const { return dependence_; }
    /// How often the maximum length of pieces of curves was doubled to find room.
    int coarseness() const { return coarseness_; }
    /// The number of objects whose hatching had to be wider than written, to find room.
    std::uint32_t wider_hatchings() const { return wider_hatchings_; }

private:
    static constexpr int coarsest = 8;

    void trace_scene();
    void trace_leaf(SceneWalk& walk);
    void trace_object(SceneWalk& walk, const BeamStyle& beam);
    void trace_wires(SceneWalk& walk, const ObjectStrokes& strokes);
    void trace_live(SceneWalk& walk, const ItemView& item);
    template <class Trace>
    void add_lines(SceneWalk& walk, const BeamStyle& beam, Trace trace);
    template <class Trace>
    void add_hatching(SceneWalk& walk, const BeamStyle& beam, Trace trace);
    template <class DrawWith>
    void draw(BeamInk ink, Colour colour, SceneWalk& walk, DrawWith draw_with);

    const SceneOnPanel& on_panel_;
    int resolution_;
    BeamLines& lines_;
    Dependence dependence_;
    int coarseness_ = 0;
    std::uint32_t wider_hatchings_ = 0;
};

}
