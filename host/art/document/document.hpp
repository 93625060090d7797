#pragma once

#include "core/pixel/paint_style.hpp"
#include "core/time/time.hpp"
#include "host/art/animation/animated.hpp"
#include "host/art/budget.hpp"
#include "host/art/geometry/affine.hpp"
#include "host/art/geometry/drawing.hpp"

#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// What the importers make of other programs' files: an animation in doubles, as near to the language of
/// scenes as these files allow. Coordinates are canvas pixels, y down; times are frames, the scene beginning
/// at 0; angles are degrees, clockwise; fractions and colour channels are 0 to 1.
namespace kfast::art {

struct Rgb {
    double red = 0;
    double green = 0;
    double blue = 0;
    friend bool operator==(const Rgb&, const Rgb&) = default;
};

constexpr Rgb mixed(const Rgb& from, const Rgb& to, double share)
{
    return {mixed(from.red, to.red, share), mixed(from.green, to.green, share),
            mixed(from.blue, to.blue, share)};
}

/// Inside of a drawing.
struct Fill {
    Animated<Rgb> colour;
    Channel opacity = {1};
    FillRule rule = FillRule::nonzero;
    friend bool operator==(const Fill&, const Fill&) = default;
};

/// How a line is broken, as in SVG and Lottie.
struct Dashes {
    static constexpr std::size_t max_lengths = 6; ///< that a scene has (core/math/dashes.hpp)
    static constexpr double finest_period = 0.25; ///< pixels; shorter ones are as good as an even line

    std::vector<Channel> lengths; ///< of dashes and gaps alternately, in pixels; none: no dashes
    Channel offset = {0};         ///< how far into the pattern each outline begins, in pixels
    friend bool operator==(const Dashes&, const Dashes&) = default;
};

/// The sum of the lengths at a time. Between keys they may go below 0, which is 0.
double period_at(const Dashes& dashes, double time);
/// Whether none of the lengths changes.
bool has_still_lengths(const Dashes& dashes);

/// Along a drawing.
struct StrokeStyle {
    Animated<Rgb> colour;
    Channel opacity = {1};
    Channel width = {1};
    Cap cap = Cap::butt;
    Join join = Join::miter;
    double miter_limit = 4; ///< in widths
    Dashes dashes = {};
    friend bool operator==(const StrokeStyle&, const StrokeStyle&) = default;
};

/// How far a point follows a bone.
struct BoneInfluence {
    std::size_t bone = 0; ///< index into Rig::bones
    double weight = 0;    ///< above 0; only their ratios matter
    friend bool operator==(const BoneInfluence&, const BoneInfluence&) = default;
};

/// Which bones deform a shape.
struct Skin {
    std::size_t rig = 0; ///< index into Document::rigs
    /// For each point of the first drawing, as the scene language counts them: where an outline begins, and
    /// where its curves end but for the closing point. One to four each.
    std::vector<std::vector<BoneInfluence>> points;
    bool turns_changes = false; ///< the changes of later drawings rotate with the bones
    friend bool operator==(const Skin&, const Skin&) = default;
};

/// Which part of the outlines of a shape is drawn.
struct Trim {
    Channel start = {0};   ///< fraction of the length, 0 to 1
    Channel end = {1};     ///< the same; may be the smaller one
    Channel offset = {0};  ///< fraction of the length, any; 1 is once around
    bool together = false; ///< all outlines count as one, in their order; otherwise each by itself
    friend bool operator==(const Trim&, const Trim&) = default;
};

/// Something drawn: has a fill or a line or both, the line over the fill.
struct Shape {
    Animated<Drawing> drawing;
    std::optional<Fill> fill;
    std::optional<StrokeStyle> stroke;
    std::optional<Skin> skin;
    std::optional<Trim> trim;
    bool matches_length = false; ///< where forms differ, points match by arc length rather than by count
    friend bool operator==(const Shape&, const Shape&) = default;
};

struct Node;

/// Nodes that move and fade together.
struct Group {
    std::vector<Node> nodes; ///< the first is the lowest
};

/// How many copies of a symbol a use makes: the copy with the number n, from 0, is scaled to the power of n,
/// rotated by n steps, both about (0, 0), and moved by n steps. The first is the lowest.
struct Copies {
    static constexpr int max = 1000;

    int count = 1; ///< 1 to max
    double x = 0;
    double y = 0;
    double rotation = 0; ///< -360 to 360
    double scale = 1;    ///< a factor above 0
    double opacity = 0;  ///< added to 1, which is that of the first
    friend bool operator==(const Copies&, const Copies&) = default;
};

/// What a symbol draws, by a time of its own: that is 0 until `delay`, and then goes on at `speed`, as Clock
/// has it. If `speed` is negative, it begins at the end of the symbol.
struct Use {
    std::size_t symbol = 0; ///< index into Document::symbols
    double delay = 0;
    double speed = 1; ///< not 0
    Copies copies = {};
    friend bool operator==(const Use&, const Use&) = default;
};

/// A curve to move along.
struct MotionPath {
    Drawing path;       ///< one open outline with at least one curve
    Channel share;      ///< fraction of its length
    bool turns = false; ///< its direction is added to the rotation about z
    friend bool operator==(const MotionPath&, const MotionPath&) = default;
};

/// What a node does to its content: it skews, scales, rotates about z, then y, then x, all about its anchor,
/// and moves so that the anchor is at the position.
struct Transform {
    Channel anchor_x = {0};
    Channel anchor_y = {0};
    Channel x = {0}; ///< where the anchor goes
    Channel y = {0};
    std::optional<MotionPath> path; ///< instead of x and y
    Channel z = {0};                ///< towards the viewer
    Channel scale_x = {1};
    Channel scale_y = {1};
    Channel rotate = {0}; ///< about z
    Channel rotate_x = {0};
    Channel rotate_y = {0};
    /// Lottie's: the content is rotated by the axis, sheared by the tangent of the skew, and rotated back.
    Channel skew = {0};
    Channel skew_axis = {0};
    friend bool operator==(const Transform&, const Transform&) = default;
};

/// From, inclusive, to, exclusive.
struct Span {
    double from = -std::numeric_limits<double>::infinity();
    double to = std::numeric_limits<double>::infinity();
    friend bool operator==(const Span&, const Span&) = default;
};

/// One layer, group or shape of the file.
struct Node {
    std::string name; ///< as in the file; may be empty, and need not be unique
    Transform transform;
    Channel opacity = {1};                          ///< of the finished picture of all that is inside
    std::vector<Span> shown = std::vector<Span>(1); ///< when visible: ascending, disjoint; none: never
    /// Not 0: neighbours with the same number are one group, written for each of its members because others
    /// may be between them (a parent in Lottie). Their transforms are the same.
    std::size_t parent_tag = 0;
    std::variant<Shape, Group, Use> content;
};

bool operator==(const Node& left, const Node& right);
inline bool operator==(const Group& left, const Group& right) { return left.nodes == right.nodes; }

/// A bone as set up, where its shapes are drawn, and how poses change that: see "Poses" in
/// docs/scene-language.md.
struct Bone {
    std::string name;
    std::optional<std::size_t> parent; ///< index of an earlier bone
    scene::Vec2 from;                  ///< as set up
    scene::Vec2 to;                    ///< not `from`
    Channel rotation = {0};            ///< from the direction as set up
    Channel x = {0};                   ///< of its origin, from that as set up, in directions as set up
    Channel y = {0};
    std::optional<Channel> length; ///< in pixels; as set up without it
    bool at_tip = false;           ///< its beginning moves with the length of its parent
};

/// A skeleton, in the coordinates of the shapes that it deforms.
struct Rig {
    std::string name;
    std::vector<Bone> bones; ///< at least one
};

/// A named time, or a range of time.
struct Marker {
    std::string name;
    double time = 0;
    double duration = 0;
};

/// What is used more than once, or by a time of its own. Times in it are its own, from 0 on.
struct Symbol {
    std::string name;
    double frames = 1;        ///< its length
    std::optional<Loop> loop; ///< what happens at its end; nothing: it has none
    std::vector<Node> nodes;  ///< the first is the lowest
};

struct Document {
    double width = 0; ///< canvas pixels, above 0
    double height = 0;
    double frame_rate = 30; ///< frames per second
    double frames = 1;      ///< length of the scene
    Loop loop = Loop::repeat;
    std::optional<Rgb> background;
    std::optional<double> camera; ///< distance of the viewer, in pixels; without one, depth is not visible
    std::vector<Node> nodes;      ///< the first is the lowest
    std::vector<Symbol> symbols;  ///< each comes after those that it uses
    std::vector<Rig> rigs;
    std::vector<Marker> markers;
};

/// Calls `visit` with everything that can change, of whatever type of value.
template <typename Visit>
void every_animation(Transform& transform, Visit&& visit)
{
    for (Channel* channel : {&transform.anchor_x, &transform.anchor_y, &transform.x, &transform.y,
                             &transform.z, &transform.scale_x, &transform.scale_y, &transform.rotate,
                             &transform.rotate_x, &transform.rotate_y, &transform.skew, &transform.skew_axis})
        visit(*channel);
    if (transform.path)
        visit(transform.path->share);
}

/// Calls visit(channel) with all that is in pixels.
template <typename Visit>
void every_length(StrokeStyle& stroke, Visit&& visit)
{
    visit(stroke.width);
    for (Channel& length : stroke.dashes.lengths)
        visit(length);
    visit(stroke.dashes.offset);
}

template <typename Visit>
void every_animation(Shape& shape, Visit&& visit)
{
    visit(shape.drawing);
    if (shape.fill) {
        visit(shape.fill->colour);
        visit(shape.fill->opacity);
    }
    if (shape.stroke) {
        visit(shape.stroke->colour);
        visit(shape.stroke->opacity);
        every_length(*shape.stroke, visit);
    }
    if (shape.trim)
        for (Channel* channel : {&shape.trim->start, &shape.trim->end, &shape.trim->offset})
            visit(*channel);
}

template <typename Visit>
void every_animation(Bone& bone, Visit&& visit)
{
    for (Channel* channel : {&bone.rotation, &bone.x, &bone.y})
        visit(*channel);
    if (bone.length)
        visit(*bone.length);
}

/// Calls visit(node, place) with each node, the outer ones first; `place` are the names from the outermost
/// on, as Loss::layer has them. Throws Failure if they are nested too deeply.
template <typename Visit>
void every_node(std::vector<Node>& nodes, Visit&& visit, const std::string& around = {}, int depth = 0)
{
    Budget::check_depth(depth);
    for (Node& node : nodes) {
        const std::string place = around.empty() ? node.name : around + " / " + node.name;
        visit(node, place);
        if (auto* group = std::get_if<Group>(&node.content))
            every_node(group->nodes, visit, place, depth + 1);
    }
}

/// The same with the nodes of the document, and with those of its symbols.
template <typename Visit>
void every_node(Document& document, Visit&& visit)
{
    every_node(document.nodes, visit);
    for (Symbol& symbol : document.symbols)
        every_node(symbol.nodes, visit, symbol.name);
}

/// Degrees: at a skew of 90 the content has no width, so no skew is larger.
inline constexpr double steepest_skew = 89.9;

/// What the transform does to its content at a time, along its path if it has one; without its depth and its
/// rotations about x and y.
Affine matrix_at(const Transform& transform, double time);

/// As matrix_at() without the position and the path: rotation, scale and skew alone.
Affine shape_at(const Transform& transform, double time);

/// What the copy with that number does to the symbol.
Affine matrix_of(const Copies& copies, int number);

}
