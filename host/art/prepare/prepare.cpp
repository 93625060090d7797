#include "host/art/prepare/prepare.hpp"

#include "host/art/animation/ease.hpp"
#include "host/art/document/document.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace kfast::art {

namespace {

using scene::Outline;
using scene::Vec2;

/// Multiplies lengths and positions, at all times.
class Growth {
public:
    explicit Growth(double factor) : factor_{factor} {}

    void operator()(double& length) const { length *= factor_; }
    void operator()(Vec2& spot) const { spot = factor_ * spot; }

    void operator()(Outline& outline) const
    {
        (*this)(outline.from);
        for (scene::Curve& curve : outline.curves)
            for (Vec2* spot : {&curve.c1, &curve.c2, &curve.to})
                (*this)(*spot);
    }

    void operator()(Drawing& drawing) const
    {
        for (Outline& outline : drawing.outlines)
            (*this)(outline);
    }

    template <typename Value>
    void operator()(Animated<Value>& animated) const
    {
        for (auto& key : animated.keys)
            (*this)(key.value);
    }

    void operator()(Transform& transform) const
    {
        for (Channel* channel :
             {&transform.anchor_x, &transform.anchor_y, &transform.x, &transform.y, &transform.z})
            (*this)(*channel);
        if (transform.path)
            (*this)(transform.path->path);
    }

    void operator()(Node& node) const
    {
        (*this)(node.transform);
        if (auto* shape = std::get_if<Shape>(&node.content)) {
            (*this)(shape->drawing);
            if (shape->stroke)
                every_length(*shape->stroke, *this);
        }
        if (auto* use = std::get_if<Use>(&node.content)) {
            (*this)(use->copies.x);
            (*this)(use->copies.y);
        }
    }

    void operator()(Bone& bone) const
    {
        (*this)(bone.from);
        (*this)(bone.to);
        (*this)(bone.x);
        (*this)(bone.y);
        if (bone.length)
            (*this)(*bone.length);
    }

private:
    double factor_;
};

}

void scale(Document& document, double factor)
{
    const Growth grow{factor};
    grow(document.width);
    grow(document.height);
    if (document.camera)
        grow(*document.camera);
    every_node(document, [&](Node& node, const std::string&) { grow(node); });
    for (Rig& rig : document.rigs)
        for (Bone& bone : rig.bones)
            grow(bone);
}

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// Drawings of different form are tweened by the player alone: only the ends of such a transition are known.
template <typename Value>
bool can_divide(const Value&, const Value&)
{
    return true;
}
bool can_divide(const Drawing& from, const Drawing& to) { return same_form(from, to); }

/// Cuts animations to a range of time that begins at 0.
class Crop {
public:
    explicit Crop(double frames) : frames_{frames} {}

    template <typename Value>
    void operator()(Animated<Value>& animated)
    {
        const auto& keys = animated.keys;
        if (keys.front().time >= 0 && keys.back().time <= frames_)
            return;
        std::vector<Key<Value>> kept;
        for (std::size_t i = 0; i + 1 < keys.size(); ++i)
            keep_way(keys[i], keys[i + 1], kept);
        if (kept.empty())
            kept.push_back({0, animated.at(0), {}});
        else
            keep_end(animated, kept);
        animated.keys = std::move(kept);
    }

    /// Whether a transition began before 0 that could not be divided: it begins at 0 now.
    bool shortened() const { return shortened_; }

private:
    template <typename Value>
    void keep_way(const Key<Value>& key, const Key<Value>& next, std::vector<Key<Value>>& kept)
    {
        if (next.time <= 0 || key.time >= frames_)
            return;
        const double begin = std::max(0.0, key.time);
        if (!can_divide(key.value, next.value)) {
            shortened_ = shortened_ || (key.time < 0 && key.ease.kind != EaseKind::hold);
            kept.push_back({begin, key.value, key.ease});
            return;
        }
        const double span = next.time - key.time;
        const double share_from = (begin - key.time) / span;
        const double share_to = std::min(1.0, (frames_ - key.time) / span);
        if (!(share_from < share_to))
            return;
        for (const EasePart& part : ease_parts(key.ease, share_from, share_to)) {
            const double time = part.from <= share_from ? begin : key.time + part.from * span;
            if (kept.empty() || time > kept.back().time)
                kept.push_back({time, mixed(key.value, next.value, part.way_from), part.ease});
        }
    }

    template <typename Value>
    void keep_end(const Animated<Value>& animated, std::vector<Key<Value>>& kept)
    {
        const auto& keys = animated.keys;
        const auto after = std::ranges::find_if(keys, [&](const auto& key) { return key.time >= frames_; });
        if (after == keys.end())
            kept.push_back(keys.back());
        else if (after->time == frames_ || !can_divide(std::prev(after)->value, after->value))
            kept.push_back(*after);
        else
            kept.push_back({frames_, animated.at(frames_), {}});
    }

    double frames_;
    bool shortened_ = false;
};

/// How long a scene or a symbol is, and what happens at its end.
struct Length {
    double frames;
    Loop loop;
};

/// What is visible all along gets an unbounded span.
std::vector<Span> cropped(const std::vector<Span>& shown, const Length& length)
{
    std::vector<Span> kept;
    for (const Span& span : shown) {
        // What repeats never shows the time of its end.
        const bool ends_behind =
            span.to > length.frames || (span.to == length.frames && length.loop == Loop::repeat);
        const bool begins_behind =
            span.from > length.frames || (span.from == length.frames && length.loop == Loop::repeat);
        if (span.to <= 0 || begins_behind)
            continue;
        kept.push_back(span);
        if (span.from <= 0)
            kept.back().from = -endless;
        if (ends_behind)
            kept.back().to = endless;
    }
    return kept;
}

void crop(Node& node, const std::string& place, const Length& length, Losses& losses)
{
    Crop cut{length.frames};
    node.shown = cropped(node.shown, length);
    cut(node.opacity);
    every_animation(node.transform, cut);
    if (auto* shape = std::get_if<Shape>(&node.content))
        every_animation(*shape, cut);
    if (cut.shortened())
        losses.add({"a drawing on its way, before the scene begins, to one of other form", place, 0,
                    "the way begins at 0"});
}

std::vector<Marker> cropped(std::vector<Marker> markers, double frames, Losses& losses)
{
    std::vector<Marker> kept;
    for (Marker& marker : markers) {
        const double end = std::min(marker.time + marker.duration, frames);
        const double begin = std::max(marker.time, 0.0);
        if (begin > frames || end < 0) {
            losses.add({"marker " + marker.name, "", marker.time,
                        "nothing: it lies outside of the time that is played"});
            continue;
        }
        kept.push_back({std::move(marker.name), begin, end - begin});
    }
    return kept;
}

}

void crop(Document& document, Losses& losses)
{
    const auto crop_all = [&](std::vector<Node>& nodes, const Length& length, const std::string& around) {
        every_node(
            nodes, [&](Node& node, const std::string& place) { crop(node, place, length, losses); }, around);
    };
    crop_all(document.nodes, {document.frames, document.loop}, {});
    for (Symbol& symbol : document.symbols)
        crop_all(symbol.nodes, {symbol.frames, symbol.loop.value_or(Loop::once)}, symbol.name);
    Crop cut{document.frames};
    for (Rig& rig : document.rigs)
        for (Bone& bone : rig.bones)
            every_animation(bone, cut);
    document.markers = cropped(std::move(document.markers), document.frames, losses);
}

namespace {

/// Controls are rounded to 1 divided by these, the finest first; that of the scene language is not among the
/// losses, for it loses nothing.
constexpr std::array grids{8192.0, 128.0, 64.0, 32.0, 16.0, 8.0, 4.0, 2.0};

Ease rounded(const Ease& ease, double grid)
{
    const auto near = [grid](double control) { return std::round(control * grid) / grid; };
    return {ease.kind, near(ease.x1), near(ease.y1), near(ease.x2), near(ease.y2)};
}

template <typename Visit>
void every_ease(Document& document, Visit&& visit)
{
    const auto look_at = [&](auto& animated) {
        for (auto& key : animated.keys)
            if (key.ease.kind == EaseKind::cubic)
                visit(key.ease);
    };
    every_node(document, [&](Node& node, const std::string&) {
        every_animation(node.transform, look_at);
        look_at(node.opacity);
        if (auto* shape = std::get_if<Shape>(&node.content))
            every_animation(*shape, look_at);
    });
    for (Rig& rig : document.rigs)
        for (Bone& bone : rig.bones)
            every_animation(bone, look_at);
}

std::size_t different_eases(Document& document, double grid)
{
    std::set<std::tuple<double, double, double, double>> found;
    every_ease(document, [&](const Ease& ease) {
        const Ease near = rounded(ease, grid);
        found.emplace(near.x1, near.y1, near.x2, near.y2);
    });
    return found.size();
}

}

void share_eases(Document& document, Losses& losses)
{
    const std::size_t before = different_eases(document, grids.front());
    if (before <= max_eases)
        return;
    double grid = 0;
    std::size_t after = before;
    for (std::size_t i = 1; i < grids.size() && after > max_eases; ++i) {
        grid = grids[i];
        after = different_eases(document, grid);
    }
    every_ease(document, [grid](Ease& ease) { ease = rounded(ease, grid); });
    losses.add({std::to_string(before) + " different eases", "", std::nullopt,
                std::to_string(after) + " of them, each near to those that it replaces"});
}

}
