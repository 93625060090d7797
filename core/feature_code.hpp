#pragma once

#include "core/bytes/function_ref.hpp"
#include "core/features.hpp"

#include <cstdint>
#include <optional>
#include <span>

/// The rest of the player reaches the code of a feature through these pointers alone, so that a linker can
/// leave it out. Objects that only a feature makes (StrokeOutline, PosedBackbones, Projection,
/// DeformedDrawing) carry pointers to what works on them.
namespace kfast {

class DeformedDrawing;
class PosedBackbones;
class PosedBone;
class InputDrawings;
class ObjectOutline;
class ObjectStrokes;
class PackedDrawing;
class PictureCache;
class PreparedScene;
class Preparer;
class ReadAllowance;
class SceneCheck;
class SceneView;
class SceneWalk;
class StrokeOutline;
class Tracer;
struct Affine;
struct BackbonesView;
struct DrawingInput;
struct ItemView;
struct Key;
struct LabelView;
struct TrackState;
struct PathPlace;
struct PathView;
struct Pen;
struct Point;
struct Space;
struct TextInput;
struct Turning;

namespace raster {
class OutlineStore;
}

struct StrokeFeature {
    void (*emplace)(std::optional<StrokeOutline>&, raster::OutlineStore&, const Pen&, int coarseness);
};

struct TweenFeature {
    void (*trace)(const ObjectStrokes&, const Affine& placement, ObjectOutline&);
    void (*trace_kept)(const ObjectStrokes&, PictureCache&, const Affine& placement, ObjectOutline&);
};

struct BoneFeature {
    bool (*check)(const SceneView&, std::uint32_t laws, ReadAllowance&);
    bool (*check_skin)(SceneCheck&, const Key&, std::uint32_t bones);
    void (*prepare)(Preparer&);
    void (*set_up)(const SceneView&, const PreparedScene&, std::span<PosedBone>);
    void (*pose)(const SceneView&, const PreparedScene&, std::span<PosedBone>);
    DeformedDrawing (*deformed)(const ObjectStrokes&, std::uint32_t drawing, std::int32_t skin);
};

struct BackboneFeature {
    bool (*check)(SceneCheck&, const BackbonesView&);
    const PosedBackbones& (*live)(const ObjectStrokes&, PictureCache*);
};

struct DepthFeature {
    Space (*tilted)(const Turning&);
    Space (*product)(const Space& outer, const Space& inner);
    void (*add_layers)(Tracer&, SceneWalk&, FunctionRef<Point()> first_point,
                       FunctionRef<void(const Affine&, ObjectOutline&)> trace);
};

struct WireFeature {
    bool (*check)(SceneCheck&, const Key&);
    void (*trace)(Tracer&, const ObjectStrokes&, SceneWalk&);
};

struct PathFeature {
    bool (*check)(SceneCheck&, const ItemView&);
    PathPlace (*place_on)(const PathView&, PackedDrawing, std::int32_t share);
};

struct SmoothFeature {
    std::int32_t (*value)(const PreparedScene&, const SceneView&, const TrackState&);
};

struct TextFeature {
    bool (*check)(SceneCheck&, const LabelView&, const TextInput&);
    void (*trace)(Tracer&, SceneWalk&);
};

struct DrawingFeature {
    bool (*check)(SceneCheck&, const DrawingInput&);
    void (*show_default)(const InputDrawings&, const SceneView&);
    void (*trace)(Tracer&, SceneWalk&);
};

}
