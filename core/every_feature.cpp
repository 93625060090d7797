#include "core/features.hpp"

#include "core/bytes/function_ref.hpp"
#include "core/math/projection.hpp"
#include "core/pose/input_drawing.hpp"
#include "core/pose/object_strokes.hpp"
#include "core/pose/posed_bones.hpp"
#include "core/prepared/preparer.hpp"
#include "core/raster/outline/stroke_outline.hpp"
#include "core/raster/outline/trimmed_outline.hpp"
#include "core/scene/check/scene_check.hpp"
#include "core/scene/track_view.hpp"
#include "core/time/spring_law.hpp"
#include "core/tracer.hpp"

using namespace kfast;

const StrokeFeature kfast_strokes{.emplace = emplace_stroke_outline};
const TweenFeature kfast_tweens{.trace = plain_function<&ObjectStrokes::trace_tween<ObjectOutline>>,
                                .trace_kept = plain_function<&ObjectStrokes::trace_kept_tween>};
const BoneFeature kfast_bones{.check = are_bones_valid,
                              .check_skin = plain_function<&SceneCheck::check_skin>,
                              .prepare = plain_function<&Preparer::add_skeletons>,
                              .set_up = set_up_bones,
                              .pose = pose_bones,
                              .deformed = plain_function<&ObjectStrokes::deformed_by_bones>};
const BackboneFeature kfast_backbones{.check = plain_function<&SceneCheck::check_backbones>,
                                      .live = plain_function<&ObjectStrokes::posed_backbones>};
const DepthFeature kfast_depth{.tilted = tilted,
                               .product = product_in_depth,
                               .add_layers = plain_function<&Tracer::add_layers_in_depth>};
const WireFeature kfast_wires{.check = plain_function<&SceneCheck::check_depths>,
                              .trace = plain_function<&Tracer::trace_wires>};
const PathFeature kfast_paths{.check = plain_function<&SceneCheck::check_path>, .place_on = place_on};
const SmoothFeature kfast_smooth{.value = plain_function<&PreparedScene::smooth_value>};
const TextFeature kfast_texts{.check = plain_function<&SceneCheck::check_label>,
                              .trace = plain_function<&Tracer::trace_label>};
const DrawingFeature kfast_drawings{.check = plain_function<&SceneCheck::check_default>,
                                    .show_default = plain_function<&InputDrawings::show_default>,
                                    .trace = plain_function<&Tracer::trace_drawing>};
const TrimFeature kfast_trims{.trace = trace_trimmed};
const SpringFeature kfast_springs{.progress = spring_progress};

namespace kfast {

const Features every_feature{.strokes = &kfast_strokes,
                             .tweens = &kfast_tweens,
                             .bones = &kfast_bones,
                             .backbones = &kfast_backbones,
                             .depth = &kfast_depth,
                             .wires = &kfast_wires,
                             .paths = &kfast_paths,
                             .smooth = &kfast_smooth,
                             .texts = &kfast_texts,
                             .drawings = &kfast_drawings,
                             .trims = &kfast_trims,
                             .springs = &kfast_springs};

namespace {

constexpr StrokeFeature strokes_of_beams{.emplace = nullptr};
constexpr TweenFeature tweens_of_beams{.trace = nullptr, .trace_kept = nullptr};
constexpr DepthFeature depth_of_beams{.tilted = tilted, .product = product_in_depth, .add_layers = nullptr};
constexpr WireFeature wires_of_beams{.check = plain_function<&SceneCheck::check_depths>, .trace = nullptr};
constexpr TextFeature texts_of_beams{.check = plain_function<&SceneCheck::check_label>, .trace = nullptr};
constexpr DrawingFeature drawings_of_beams{.check = plain_function<&SceneCheck::check_default>,
                                           .show_default = plain_function<&InputDrawings::show_default>,
                                           .trace = nullptr};
constexpr TrimFeature trims_of_beams{.trace = nullptr};

}

const Features every_feature_but_outlines{.strokes = &strokes_of_beams,
                                          .tweens = &tweens_of_beams,
                                          .bones = &kfast_bones,
                                          .backbones = &kfast_backbones,
                                          .depth = &depth_of_beams,
                                          .wires = &wires_of_beams,
                                          .paths = &kfast_paths,
                                          .smooth = &kfast_smooth,
                                          .texts = &texts_of_beams,
                                          .drawings = &drawings_of_beams,
                                          .trims = &trims_of_beams,
                                          .springs = &kfast_springs};

}
