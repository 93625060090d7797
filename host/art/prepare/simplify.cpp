#include "host/art/prepare/prepare.hpp"

#include "host/art/budget.hpp"
#include "host/art/document/document.hpp"
#include "host/art/document/extent.hpp"
#include "host/art/document/value_distance.hpp"
#include "host/art/geometry/curves.hpp"
#include "host/art/prepare/fewer_keys.hpp"
#include "host/art/prepare/tween_turn.hpp"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <map>
#include <numbers>

// How the tolerance is divided, so that everything together moves what is visible by no more than that: half
// of it belongs to the drawing, half to the transforms around it, where all channels that move it on its way
// to the canvas, its own and those of all groups around it, have equal parts. A drawing that no channel moves
// has all. Of the part of a drawing with several keys, five eighths go into making them equal and leaving
// them out, the rest into merging its curves; a still one has all for that.
//
// A part is converted to a tolerance of the channel by how far what it moves can be from the anchor, and by
// how much the groups around enlarge it at most; perspective included.
namespace kfast::art {
namespace {

/// For opacities, which are stored in 1/255, and some of which are stacked.
constexpr double opacity_tolerance = 0.25 / 255;
constexpr double colour_tolerance = 0.5 / 255;
/// For the channels of bones: nothing but rounding errors.
constexpr double bone_tolerance = 1e-9;

int moves(const Channel& channel)
{
    const Range range = range_of(channel);
    return range.low < range.high ? 1 : 0;
}

int moving_channels(const Transform& transform)
{
    int count = transform.path ? moves(transform.path->share) : moves(transform.x) + moves(transform.y);
    for (const Channel* channel :
         {&transform.anchor_x, &transform.anchor_y, &transform.z, &transform.scale_x, &transform.scale_y,
          &transform.rotate, &transform.rotate_x, &transform.rotate_y})
        count += moves(*channel);
    return count;
}

/// What has to be known of a node before it is changed.
struct Measured {
    Extent content;   ///< in its own coordinates
    int channels = 0; ///< that move something in it: the most on one path, its own included
    std::vector<Measured> inner;
};

/// Nodes with the same tag have the same transform, and keep it only if they are measured together.
void join_tagged(const std::vector<Node>& nodes, std::vector<Measured>& list)
{
    std::map<std::size_t, Measured> joined;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        Measured& all = joined[nodes[i].parent_tag];
        all.content.take(list[i].content);
        all.channels = std::max(all.channels, list[i].channels);
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (nodes[i].parent_tag == 0)
            continue;
        list[i].content = joined[nodes[i].parent_tag].content;
        list[i].channels = joined[nodes[i].parent_tag].channels;
    }
}

class Measurement {
public:
    explicit Measurement(const Document& document) : rigs_{document.rigs}
    {
        for (const Symbol& symbol : document.symbols)
            symbols_.push_back(inside(symbol.nodes, 0));
    }

    /// All that is in a list.
    Measured inside(const std::vector<Node>& nodes, int depth) const
    {
        Measured all;
        all.inner = of_each(nodes, depth);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            all.content.take(placed(all.inner[i].content, nodes[i].transform));
            all.channels = std::max(all.channels, all.inner[i].channels);
        }
        return all;
    }

    const Measured& of_symbol(std::size_t index) const { return symbols_[index]; }

private:
    Measured of(const Node& node, int depth) const
    {
        Measured result;
        if (const auto* shape = std::get_if<Shape>(&node.content)) {
            result.content = extent_of(*shape, rigs_);
            result.channels = shape->stroke ? moves(shape->stroke->width) : 0;
        } else if (const auto* use = std::get_if<Use>(&node.content)) {
            result.content = copied(symbols_[use->symbol].content, use->copies);
            result.channels = symbols_[use->symbol].channels;
        } else {
            result = inside(std::get<Group>(node.content).nodes, depth + 1);
        }
        result.channels += moving_channels(node.transform);
        return result;
    }

    std::vector<Measured> of_each(const std::vector<Node>& nodes, int depth) const
    {
        Budget::check_depth(depth);
        std::vector<Measured> list;
        list.reserve(nodes.size());
        for (const Node& node : nodes)
            list.push_back(of(node, depth));
        join_tagged(nodes, list);
        return list;
    }

    std::span<const Rig> rigs_;
    std::vector<Measured> symbols_;
};

/// What is around a node.
struct Around {
    double scale_factor = 1; ///< a pixel of it is at most this many on the canvas
    int channels = 0;        ///< that move it

    void take(const Around& other)
    {
        scale_factor = std::max(scale_factor, other.scale_factor);
        channels = std::max(channels, other.channels);
    }
};

/// Keys that are nearly equal become equal: what does not change or recurs is stored once.
void make_equal(Animated<Drawing>& drawing, double tolerance)
{
    auto& keys = drawing.keys;
    const double in_keys = tolerance / tween_growth(tweens_of(drawing));
    for (std::size_t i = 1; i < keys.size(); ++i)
        for (const std::size_t other : {i - 1, std::size_t{0}})
            if (same_form(keys[i].value, keys[other].value) &&
                distance(keys[i].value, keys[other].value) <= in_keys) {
                keys[i].value = keys[other].value;
                break;
            }
}

bool has_corners(const std::optional<StrokeStyle>& stroke)
{
    return stroke && (stroke->join != Join::round || stroke->cap != Cap::round);
}

/// The length of the path; never too short.
double way_length(const MotionPath& path)
{
    constexpr double slack = 1.01;
    double length = 1e-6;
    for (const scene::Outline& outline : path.path.outlines)
        length += slack * outline_length(outline);
    return length;
}

class Simplification {
public:
    Simplification(const Document& document, double tolerance)
        : tolerance_{tolerance},
          rigs_{document.rigs},
          deep_{has_depth(document)},
          around_symbols_(document.symbols.size(), {0, 0})
    {
    }

    void simplify(std::vector<Node>& nodes, const std::vector<Measured>& list, const Around& around)
    {
        Tagged tagged;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            simplify(nodes[i], list[i], around, tagged);
    }

    /// All that uses the symbol has been simplified.
    const Around& around_symbol(std::size_t index) const { return around_symbols_[index]; }

    void simplify(Bone& bone)
    {
        every_animation(bone, [&](Channel& channel) { leave_out_keys(channel, bone_tolerance, eases_); });
    }

private:
    /// A simplified transform, and its scale factor.
    struct Placing {
        Transform transform;
        double scale_factor;
    };
    using Tagged = std::map<std::size_t, Placing>;

    void simplify(Node& node, const Measured& of, const Around& around, Tagged& tagged)
    {
        const int channels = around.channels + of.channels;
        const double share = channels > 0 ? tolerance_ / 2 / channels : 0;
        const int moving = around.channels + moving_channels(node.transform);
        const double scale_factor =
            around.scale_factor * place(node, of.content, share / around.scale_factor, tagged);
        leave_out_keys(node.opacity, opacity_tolerance, eases_);
        if (auto* group = std::get_if<Group>(&node.content))
            simplify(group->nodes, of.inner, {scale_factor, moving});
        else if (const auto* use = std::get_if<Use>(&node.content))
            around_symbols_[use->symbol].take({scale_factor * scale_factor_of(use->copies), moving});
        else
            simplify(std::get<Shape>(node.content), share / scale_factor,
                     (channels > 0 ? tolerance_ / 2 : tolerance_) / scale_factor);
    }

    double place(Node& node, const Extent& content, double share, Tagged& tagged)
    {
        if (const auto done = tagged.find(node.parent_tag); done != tagged.end()) {
            node.transform = done->second.transform;
            return done->second.scale_factor;
        }
        const double scale_factor = simplify(node.transform, content, share);
        if (node.parent_tag != 0)
            tagged.insert({node.parent_tag, {node.transform, scale_factor}});
        return scale_factor;
    }

    /// `share` is in pixels around the node. Returns the scale factor of the transform.
    double simplify(Transform& transform, const Extent& content, double share)
    {
        const double before = scale_factor_of(transform);
        // What is inside may have moved by its own part of the tolerance.
        const double reach = std::max(1.0, reach_of(content, transform) + tolerance_ / before);
        const double scale = share / (reach * skew_scale_factor(transform));
        const double scale_factor =
            std::max(before + scale * skew_scale_factor(transform), deep_ ? 1.0 : 0.0);
        const double degrees = share / (reach * scale_factor) * 180 / std::numbers::pi;
        const auto leave_out = [&](std::initializer_list<Channel*> channels, double tolerance) {
            for (Channel* channel : channels)
                leave_out_keys(*channel, tolerance, eases_);
        };
        leave_out({&transform.x, &transform.y, &transform.z}, share);
        leave_out({&transform.anchor_x, &transform.anchor_y}, share / scale_factor);
        leave_out({&transform.scale_x, &transform.scale_y}, scale);
        leave_out({&transform.rotate, &transform.rotate_x, &transform.rotate_y}, degrees);
        leave_out({&transform.skew, &transform.skew_axis}, 0);
        if (transform.path)
            leave_out({&transform.path->share}, share / way_length(*transform.path));
        return scale_factor;
    }

    /// The tolerances, of one of its channels and of its drawing, are in the shape's own pixels.
    void simplify(Shape& shape, double share, double drawing_share)
    {
        if (shape.fill)
            simplify(*shape.fill);
        if (shape.stroke)
            simplify(*shape.stroke, share);
        if (shape.skin && shape.skin->rig < rigs_.size())
            drawing_share /= scale_factor_of(rigs_[shape.skin->rig]);
        simplify_drawing(shape, drawing_share);
    }

    /// Simplifies each sequence of keys of one form by itself; where the player tweens from one form to
    /// another, what it does depends on their segments, and these stay.
    void simplify_drawing(Shape& shape, double share)
    {
        auto keys = std::move(shape.drawing.keys);
        std::vector<Key<Drawing>> done;
        for (auto begin = keys.begin(); begin != keys.end();) {
            const auto end = std::find_if(
                begin, keys.end(), [&](const auto& key) { return !same_form(begin->value, key.value); });
            const bool jumps_in = begin == keys.begin() || std::prev(begin)->ease.kind == EaseKind::hold;
            const bool jumps_out = end == keys.end() || std::prev(end)->ease.kind == EaseKind::hold;
            shape.drawing.keys.assign(begin, end);
            simplify_stretch(shape, share, jumps_in && jumps_out);
            std::ranges::move(shape.drawing.keys, std::back_inserter(done));
            begin = end;
        }
        shape.drawing.keys = std::move(done);
    }

    void simplify_stretch(Shape& shape, double share, bool may_merge)
    {
        auto& keys = shape.drawing.keys;
        const bool is_still = shape.drawing.is_still();
        const double begin = keys.front().time;
        const double end = keys.back().time;
        const Ease leaving = keys.back().ease;
        if (!is_still)
            simplify_keys(shape, share * keys_share);
        // Other forms before and after it begin when they did.
        if (keys.front().time > begin)
            keys.insert(keys.begin(), {begin, keys.front().value, {}});
        if (keys.back().time < end && leaving.kind != EaseKind::hold)
            keys.push_back({end, keys.back().value, {}});
        keys.back().ease = leaving;
        if (may_merge)
            merge_curves(shape, is_still ? share : share * (1 - keys_share));
    }

    static constexpr double keys_share = 5.0 / 8;

    /// A tenth is for making keys equal. Where a line shows directions, half of the rest is for these.
    void simplify_keys(Shape& shape, double share)
    {
        constexpr double equal_share = 0.1;
        constexpr double point_share = (1 - equal_share) / 2;
        Animated<Drawing>& drawing = shape.drawing;
        if (!has_corners(shape.stroke)) {
            make_equal(drawing, share * equal_share);
            return leave_out_keys(drawing, share * (1 - equal_share), eases_);
        }
        const double half_width = greatest(shape.stroke->width) / 2;
        make_equal(drawing,
                   share * equal_share / corner_motion(corner_arms(shape), tweens_of(drawing), half_width));
        leave_out_keys(drawing, share * point_share, {corner_arms(shape), half_width, share * point_share},
                       eases_);
    }

    template <typename Ink>
    void simplify_ink(Ink& ink)
    {
        leave_out_keys(ink.colour, colour_tolerance, eases_);
        leave_out_keys(ink.opacity, opacity_tolerance, eases_);
    }

    static constexpr double dash_share = 1.0 / 16; ///< errors of lengths add up along a line

    void simplify(Fill& fill) { simplify_ink(fill); }

    void simplify(StrokeStyle& stroke, double share)
    {
        simplify_ink(stroke);
        // An edge moves by half of what the width changes, a tip or the corner of a cap further.
        const double longest = std::max(stroke.miter_limit, std::numbers::sqrt2);
        leave_out_keys(stroke.width, 2 * share / longest, eases_);
        for (Channel& length : stroke.dashes.lengths)
            leave_out_keys(length, dash_share * share, eases_);
        leave_out_keys(stroke.dashes.offset, share, eases_);
    }

    double tolerance_;
    std::span<const Rig> rigs_;
    bool deep_;
    std::vector<Around> around_symbols_; ///< the most around any use of each
    NewEases eases_;
};

}

void simplify(Document& document, double tolerance)
{
    drop_unseen(document);
    const Measurement measurement{document};
    const Measured all = measurement.inside(document.nodes, 0);
    Simplification simplification{document, tolerance};
    simplification.simplify(document.nodes, all.inner, {perspective_scale_factor(document, all.content), 0});
    for (std::size_t i = document.symbols.size(); i-- > 0;)
        if (const Around around = simplification.around_symbol(i); around.scale_factor > 0)
            simplification.simplify(document.symbols[i].nodes, measurement.of_symbol(i).inner, around);
    for (Rig& rig : document.rigs)
        for (Bone& bone : rig.bones)
            simplification.simplify(bone);
}

}
