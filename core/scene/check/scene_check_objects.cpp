#include "core/features.hpp"
#include "core/scene/check/scene_check.hpp"
#include "core/scene/kfb_limits.hpp"

#include <algorithm>

/// Objects and their drawings.
namespace kfast {
namespace {

/// How many bones the skeleton has that deforms `object`; 0 if there is none.
std::uint32_t bones_of(const SceneView& scene, const ObjectView& object)
{
    if (object.deformer != Deformer::bones)
        return 0;
    SkeletonCursor skeletons = scene.skeletons();
    std::uint32_t bones = 0;
    for (std::uint32_t number = 0; number <= object.skeleton; ++number) {
        if (skeletons.at_end())
            return 0;
        bones = skeletons.skip();
    }
    return bones;
}

bool is_within(Fixed coordinate)
{
    return coordinate >= Fixed::sixteenths(kfb::min_coordinate) &&
           coordinate <= Fixed::sixteenths(kfb::max_coordinate);
}

bool is_within(Point at) { return is_within(at.x) && is_within(at.y); }

/// Whether coordinates have 16 bits, as all later code requires.
bool is_within(const Segment& segment)
{
    return is_within(segment.to) && is_within(segment.c1) && is_within(segment.c2);
}

bool is_valid(const Binding& binding, std::uint32_t bones)
{
    bool sound = true;
    binding.each([&](BoneInfluence share) { sound = sound && share.bone < bones && share.weight >= 1; });
    return sound;
}

/// Whether each point of a drawing that has been checked follows bones that exist.
[[gnu::cold, gnu::noinline]] bool has_bindings(PackedDrawing& drawing, SkinReader& skin, std::uint32_t bones)
{
    for (std::uint32_t stroke = 0; stroke < drawing.strokes(); ++stroke) {
        const std::uint32_t segments = drawing.next_stroke();
        for (std::uint32_t i = 0; i <= segments; ++i) {
            if (!is_valid(skin.next(), bones) || !skin.is_valid())
                return false;
            if (i != segments)
                drawing.next_segment();
        }
    }
    return skin.run_is_over() && skin.is_valid();
}

}

bool SceneCheck::check_object(const ObjectView& object)
{
    const bool is_filled_wire = object.has_depths && object.style.is_filled;
    return !is_filled_wire && check_style(object.style) && check_deformer(object) && check_keys(object);
}

bool SceneCheck::check_style(const ObjectStyle& style)
{
    if (style.is_filled && style.fill >= scene_.palette_size())
        return false;
    if (!style.is_stroked)
        return style.is_filled;
    return needs(Feature::strokes) && style.stroke < scene_.palette_size() && style.width >= 1 &&
           style.width <= kfb::max_width && style.cap <= Cap::square && style.join <= Join::bevel &&
           style.miter_limit >= kfb::min_miter_limit;
}

bool SceneCheck::check_keys(const ObjectView& object)
{
    KeyCursor keys = object.keys(); // at least one: KeyTimeCursor::one() stands for none
    const std::uint32_t bones = bones_of(scene_, object);
    const Key first = KeyCursor{keys}.next();
    if (object.has_arrivals && !needs(Feature::tweens))
        return false;
    Key before{.time = Time{-1}};
    for (bool is_first = true; !keys.at_end(); is_first = false) {
        const Key key = keys.next();
        const bool is_new = is_first || key.drawing != before.drawing || key.more != before.more;
        if ((key.drawing != first.drawing || key.more != first.more) && !needs(Feature::tweens))
            return false;
        if (key.time <= before.time || !is_moment(keys.key_times().driver(), key.time) || !is_law(key.laws) ||
            !(is_new ? check_drawings(object, key, bones) : may_read(1)))
            return false;
        if (object.has_arrivals && !check_drawing(key.arrival))
            return false;
        before = key;
    }
    return true;
}

/// Checks the drawing of a key, and what belongs to it.
bool SceneCheck::check_drawings(const ObjectView& object, const Key& key, std::uint32_t bones)
{
    if (!check_drawing(key.drawing))
        return false;
    if (object.deformer == Deformer::bones && !scene_.features().bones->check_skin(*this, key, bones))
        return false; // who has skeletons has the feature: check_bones()
    return !object.has_depths || (needs(Feature::wires) && scene_.features().wires->check(*this, key));
}

bool SceneCheck::check_drawing(std::uint32_t offset)
{
    if (offset >= scene_.drawings_.size())
        return false;
    CheckedDrawing& checked = checked_[(offset ^ offset >> 5) % checked_.size()];
    const bool is_known = checked.key == offset + 1;
    if (!(is_known ? may_read(1) : check_points(offset, checked)))
        return false;
    drawing_points_ = checked.points;
    points_ = std::max(points_, drawing_points_);
    strokes_ = std::max(strokes_, scene_.drawing(offset).strokes());
    return true;
}

bool SceneCheck::check_points(std::uint32_t offset, CheckedDrawing& checked)
{
    PackedDrawing reader = scene_.drawing(offset);
    std::uint32_t points = reader.strokes();
    if (points > kfb::max_drawing_points || !may_read(points + 1))
        return false;
    for (std::uint32_t stroke = 0; stroke < reader.strokes(); ++stroke) {
        const std::uint32_t segments = reader.next_stroke();
        points += segments;
        if (!reader.is_valid() || !is_within(reader.start()) || points > kfb::max_drawing_points ||
            !may_read(segments))
            return false;
        for (std::uint32_t i = 0; i < segments; ++i)
            if (!is_within(reader.next_segment()) || !reader.is_valid())
                return false;
    }
    checked = {offset + 1, points};
    return reader.is_valid();
}

bool SceneCheck::check_deformer(const ObjectView& object)
{
    switch (object.deformer) {
    case Deformer::none:
        return true;
    case Deformer::backbones:
        return needs(Feature::backbones) && needs(Feature::tweens) &&
               scene_.features().backbones->check(*this, object.backbones);
    case Deformer::bones:
        return !object.has_arrivals && may_read(object.skeleton) && bones_of(scene_, object) != 0;
    }
    return false;
}

bool SceneCheck::check_backbones(const BackbonesView& backbones)
{
    BackboneKeyCursor keys = backbones.keys(); // at least one, as in check_keys()
    if (backbones.unit_bits < kfb::min_unit_bits || backbones.unit_bits > kfb::max_unit_bits)
        return false;
    const std::uint32_t first = backbones.keys().next().drawing;
    for (Time before{-1}; !keys.at_end();) {
        const BackboneKey key = keys.next();
        if (key.time <= before || !is_moment(keys.key_times().driver(), key.time) || !is_law(key.laws) ||
            !check_drawing(key.drawing) || !may_read(drawing_points_) ||
            !are_backbones(scene_.drawings_, key.drawing) ||
            !is_built_alike(scene_.drawings_, key.drawing, first))
            return false;
        before = key.time;
    }
    scene_.backbone_nodes_ = std::max(scene_.backbone_nodes_, backbone_node_count(scene_.drawing(first)));
    return true;
}

bool SceneCheck::check_depths(const Key& key)
{
    const auto depths = static_cast<std::uint32_t>(key.more);
    return check_drawing(depths) && may_read(drawing_points_) &&
           has_only_lines(scene_.drawings_, key.drawing) &&
           is_built_alike(scene_.drawings_, key.drawing, depths);
}

bool SceneCheck::check_skin(const Key& key, std::uint32_t bones)
{
    if (key.more < 0)
        return SceneView::bone_of(key.more) < bones;
    if (static_cast<std::size_t>(key.more) >= scene_.drawings_.size())
        return false;
    SkinReader skin = scene_.skin(key.more);
    if (skin.has_drawing_at_rest() &&
        (!check_drawing(skin.drawing_at_rest()) ||
         !is_built_alike(scene_.drawings_, key.drawing, skin.drawing_at_rest())))
        return false;
    if (!may_read(drawing_points_))
        return false;
    PackedDrawing drawing = scene_.drawing(key.drawing);
    return has_bindings(drawing, skin, bones);
}

bool SceneCheck::check_path(const ItemView& item)
{
    if (item.path.drawing >= scene_.drawings_.size())
        return false;
    PackedDrawing reader = scene_.drawing(item.path.drawing);
    const std::uint32_t segments = reader.strokes() == 1 ? reader.next_stroke() : 0;
    if (!reader.is_valid() || !is_within(reader.start()))
        return false;
    if (!may_read(segments))
        return false;
    points_ = segments;
    ByteReader lengths = item.path.lengths;
    std::uint32_t total = 0;
    for (std::uint32_t i = 0; i < segments; ++i) {
        const bool is_segment = is_within(reader.next_segment()) && reader.is_valid();
        const std::uint32_t length = lengths.varint();
        if (!is_segment || length == 0 || length > kfb::max_path)
            return false;
        total += length;
        if (total > kfb::max_path)
            return false;
    }
    return segments != 0 && lengths.left() == 0 && !lengths.overrun();
}

}
