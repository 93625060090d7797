#pragma once

#include "core/math/affine.hpp"
#include "core/math/angle.hpp"
#include "core/math/point.hpp"
#include "core/prepared/prepared_scene.hpp"
#include "core/scene/drawing_view.hpp"
#include "core/scene/packed_drawing.hpp"
#include "core/scene/scene_view.hpp"
#include "core/scene/skeleton_view.hpp"

#include <cstdint>
#include <span>

namespace kfast {

/// The origin of a bone and its direction, on the canvas.
struct BoneFrame {
    Point origin; ///< clamped to ±16383 px
    FineAngle angle;
    UnitVector direction = {}; ///< that of the angle
};

/// A bone at one time, and the map of the points that it moves.
class PosedBone {
public:
    /// Takes the set-up; `parent` has been set up, and is null for a root.
    void set_up(const BoneSetUp& bone, const PosedBone* parent);
    /// `parent` has been posed.
    void pose(const BoneSetUp& bone, const PosedBone* parent,
              std::span<const std::int32_t, bone_quantity_count> fine);

    /// O' + R(a') S R(-a) (point - O), unprimed as set up and primed as posed; S stretches along the bone as
    /// its length does, at most 64 times. Exact where the bone is as set up; clamped to ±16383 px.
    Point operator()(Point point) const;
    /// The same as a map, rounded once more, and not clamped.
    Affine map() const;

    const BoneFrame& frame() const { return posed_; }
    /// The length as posed minus that as set up.
    Fixed extension() const { return extension_; }

private:
    BoneFrame rest_;
    BoneFrame posed_;
    Fixed extension_;
    // R(a') S R(-a), Q16
    std::int32_t xx_ = Fixed::one;
    std::int32_t xy_ = 0;
    std::int32_t yx_ = 0;
    std::int32_t yy_ = Fixed::one;
};

/// Sets up all bones of the scene's skeletons; `bones` has room for scene.bone_count().
void set_up_bones(const SceneView& scene, const PreparedScene& prepared, std::span<PosedBone> bones);

/// Poses them as at the time to which the scene was moved; they have been set up.
///
/// Points up to 140 px away from the origins of their bones, none shorter than 4 px, are within 1/32 px of
/// what the stored values say, eight bones deep; within 1/16 px where angles as written turn twice between
/// two keys. Progress and lengths are rounded: errors grow with the rotation, and with distance per
/// length.
void pose_bones(const SceneView& scene, const PreparedScene& prepared, std::span<PosedBone> bones);

/// A key drawing as bones deform it at one time, or, without a skin, as it was drawn.
///
/// A point moves as it would at rest, and keeps its distance from there: p + (bones(r) - r). Control points
/// move with the vertex that they belong to. Clamped to ±4095 px, so that drawings can be tweened.
class DeformedDrawing {
public:
    explicit DeformedDrawing(const PackedDrawing& drawing) : drawing_{drawing}, at_rest_{drawing} {}
    /// `bones` are those of the skin's skeleton, posed; they must outlive this. `at_rest` is the skin's, or
    /// `drawing` again.
    DeformedDrawing(const PackedDrawing& drawing, const PackedDrawing& at_rest, const SkinReader& skin,
                    std::span<const PosedBone> bones);

    std::uint32_t strokes() const { return drawing_.strokes(); }
    std::uint32_t next_stroke();
    Point start() const { return start_; }
    Segment next_segment();

private:
    /// The functions that work on it where bones deform it: linked only with what makes such a drawing.
    struct Code {
        void (*begin_stroke)(DeformedDrawing&);
        void (*deform)(DeformedDrawing&, Segment& segment);
    };
    static const Code code;

    bool is_deformed() const { return code_ != nullptr; }
    void begin_deformed_stroke();
    void deform(Segment& segment);
    Point deformed(Point point, Point at_rest, const Binding& binding) const;

    const Code* code_ = nullptr;
    PackedDrawing drawing_;
    PackedDrawing at_rest_; ///< read in step with the other if there is one
    SkinReader skin_;
    std::span<const PosedBone> bones_;
    Point start_;
    Point at_; ///< the vertex read last, deformed
};

static_assert(DrawingReader<DeformedDrawing>);

}
