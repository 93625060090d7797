#pragma once

#include "core/bytes/function_ref.hpp"
#include "core/bytes/result.hpp"

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace kfast {

/// A part of the scene language whose code a program may leave out.
enum class Feature : std::uint8_t {
    strokes,   ///< lines and outlines, drawn with a pen
    tweens,    ///< drawings that change from key to key
    bones,     ///< skeletons, and drawings that they deform
    backbones, ///< drawings that bend along a line
    depth,     ///< rotate-x, rotate-y and z, seen in perspective
    wires,     ///< wire frames, whose points have depths of their own
    paths,     ///< items that follow a path
    smooth,    ///< tracks that go smoothly through their keys
    texts,     ///< texts among the inputs
    drawings,  ///< drawings among the inputs
    trims,     ///< strokes that are drawn in part, or dashed
    springs,   ///< velocity laws that spring or bounce
};

inline constexpr std::size_t feature_count = 12;

/// The error of a program that has not the feature, for a scene that needs it.
constexpr Error error_without(Feature feature)
{
    return static_cast<Error>(static_cast<int>(Error::needs_strokes) + static_cast<int>(feature));
}
static_assert(error_without(Feature{feature_count - 1}) == Error::needs_springs);

class FeatureSet {
public:
    constexpr FeatureSet(std::same_as<Feature> auto... features) { (add(features), ...); }

    constexpr void add(Feature feature) { bits_ = static_cast<std::uint16_t>(bits_ | bit(feature)); }
    constexpr bool has(Feature feature) const { return (bits_ & bit(feature)) != 0; }
    friend constexpr bool operator==(FeatureSet, FeatureSet) = default;

private:
    static constexpr unsigned bit(Feature feature) { return 1U << static_cast<unsigned>(feature); }

    std::uint16_t bits_ = 0;
};

struct StrokeFeature;
struct TweenFeature;
struct BoneFeature;
struct BackboneFeature;
struct DepthFeature;
struct WireFeature;
struct PathFeature;
struct SmoothFeature;
struct TextFeature;
struct DrawingFeature;
struct TrimFeature;
struct SpringFeature;

/// What a program links of the player: shapes, groups, keys, laws and tracks always, and the code of the
/// features that are not null. What nothing refers to, a linker leaves out (-ffunction-sections,
/// -fdata-sections, --gc-sections).
///
///     constexpr kfast::Features features{.strokes = &kfast_strokes};
///     const auto scene = kfast::SceneView::parse(bytes, features);
///
/// `kfast info` prints what a scene needs, `kfast export --header` writes it as such a constant.
struct Features {
    const StrokeFeature* strokes = nullptr;
    const TweenFeature* tweens = nullptr;
    const BoneFeature* bones = nullptr;
    const BackboneFeature* backbones = nullptr;
    const DepthFeature* depth = nullptr;
    const WireFeature* wires = nullptr;
    const PathFeature* paths = nullptr;
    const SmoothFeature* smooth = nullptr;
    const TextFeature* texts = nullptr;
    const DrawingFeature* drawings = nullptr;
    const TrimFeature* trims = nullptr;
    const SpringFeature* springs = nullptr;

    constexpr bool has(Feature feature) const;
};

/// All features: they play any scene. A program that names it links the whole player.
extern const Features every_feature;
/// All features without what draws outlines for a panel: to check whether a scene is valid, and for beams,
/// which trace it themselves.
extern const Features every_feature_but_outlines;

constexpr bool Features::has(Feature feature) const
{
    switch (feature) {
    case Feature::strokes:
        return strokes != nullptr;
    case Feature::tweens:
        return tweens != nullptr;
    case Feature::bones:
        return bones != nullptr;
    case Feature::backbones:
        return backbones != nullptr;
    case Feature::depth:
        return depth != nullptr;
    case Feature::wires:
        return wires != nullptr;
    case Feature::paths:
        return paths != nullptr;
    case Feature::smooth:
        return smooth != nullptr;
    case Feature::texts:
        return texts != nullptr;
    case Feature::drawings:
        return drawings != nullptr;
    case Feature::trims:
        return trims != nullptr;
    case Feature::springs:
        return springs != nullptr;
    }
    return false;
}

/// The rest of the player reaches the code of a feature through these pointers alone, so that a linker can
/// leave it out. Objects that only a feature makes (StrokeOutline, PosedBackbones, Projection,
/// DeformedDrawing) carry pointers to what works on them.

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
struct Fraction;
struct InputView;
struct ItemView;
struct Key;
struct LabelView;
struct TrackState;
struct PathPlace;
struct PathView;
struct Pen;
struct Point;
struct Progress;
struct Space;
struct Trim;
struct Turning;
struct VelocityLaw;

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
    bool (*check)(SceneCheck&, const LabelView&, const InputView&);
    void (*trace)(Tracer&, SceneWalk&);
};

struct DrawingFeature {
    bool (*check)(SceneCheck&, const DrawingInput&);
    void (*show_default)(const InputDrawings&, const SceneView&);
    void (*trace)(Tracer&, SceneWalk&);
};

struct TrimFeature {
    void (*trace)(const Trim&, const Affine& placement, ObjectOutline&,
                  FunctionRef<void(const Affine&, ObjectOutline&)> trace);
};

struct SpringFeature {
    Progress (*progress)(const VelocityLaw&, Fraction);
};

}

// The code of each feature, under names that C has, too.
// NOLINTBEGIN(readability-redundant-declaration): library/kfast.h is C and declares them itself
extern "C" {
extern const kfast::StrokeFeature kfast_strokes;
extern const kfast::TweenFeature kfast_tweens;
extern const kfast::BoneFeature kfast_bones;
extern const kfast::BackboneFeature kfast_backbones;
extern const kfast::DepthFeature kfast_depth;
extern const kfast::WireFeature kfast_wires;
extern const kfast::PathFeature kfast_paths;
extern const kfast::SmoothFeature kfast_smooth;
extern const kfast::TextFeature kfast_texts;
extern const kfast::DrawingFeature kfast_drawings;
extern const kfast::TrimFeature kfast_trims;
extern const kfast::SpringFeature kfast_springs;
}
// NOLINTEND(readability-redundant-declaration)
