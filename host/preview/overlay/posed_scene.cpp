#include "host/preview/overlay/posed_scene.hpp"

#include "core/math/projection.hpp"
#include "core/pose/object_strokes.hpp"
#include "core/scene_walk.hpp"
#include "host/beam/beam_screen.hpp"
#include "host/walk/every_item.hpp"

#include <algorithm>
#include <vector>

namespace kfast {

namespace {

constexpr int field_pixels = 1024; // any number will do: points are finer than pixels

double pixels(Fixed length) { return static_cast<double>(length.raw()) / Fixed::one; }

}

Size Viewport::posed_panel() const { return is_beam ? Size{field_pixels, field_pixels} : panel; }

PanelSpot Viewport::spot(Point posed) const
{
    const PanelSpot at{pixels(posed.x), pixels(posed.y)};
    if (!is_beam)
        return at;
    const double scale = BeamScreen::field_side_on(panel) / field_pixels;
    const double middle = field_pixels / 2.0;
    return {panel.width / 2.0 + (at.x - middle) * scale, panel.height / 2.0 + (at.y - middle) * scale};
}

PosedScene::PosedScene(const SceneView& scene, Size panel, Fit fit)
    : WordBlock{bytes_for(scene)}, SceneState{scene, panel, fit, bytes()}, items_{stored_items(scene, {})}
{
}

SceneTime PosedScene::at(Time moment) { return pose(std::clamp(moment, Time{}, scene().length())); }

std::optional<ItemView> PosedScene::item(std::size_t number) const
{
    std::optional<ItemView> found;
    every_item(scene(), [&](const ItemView& item) {
        if (number-- == 0)
            found = item;
    });
    return found;
}

void PosedScene::visit(Time moment, const Visit& visit)
{
    const SceneTime posed = at(moment);
    SceneWalk walk{on_panel(), SceneWalk::Opacity::of_leaves};
    while (walk.next() == SceneWalk::Step::leaf) {
        std::vector<std::size_t> numbers;
        for (std::size_t level = 0; level < walk.depth(); ++level)
            numbers.push_back(items_.at(scene().at(walk.node(level).place).rest().data()).number);
        visit({item_view(scene(), walk.node()), walk.node(), walk.space(), posed, walk.path(), numbers});
    }
}

namespace {

/// The transformation from the coordinates of an object to the panel.
class Sightline {
public:
    Sightline(const Space& space, const Camera& camera) : space_{space}, projection_{space, camera} {}

    Point operator()(Point point) const
    {
        return space_.is_flat() ? space_.plane(point) : projection_(point);
    }

private:
    const Space& space_;
    Projection projection_;
};

/// The tip along a bone: within 1/65536 px.
Point tip_of(const BoneView& bone, const PosedBone& live)
{
    const Fixed length = Fixed::sixteenths(bone.at_rest(BoneQuantity::length)) + live.extension();
    const BoneFrame& frame = live.frame();
    return frame.origin + Point{Fixed::from_raw(multiply(length.raw(), frame.direction.cosine, 30)),
                                Fixed::from_raw(multiply(length.raw(), frame.direction.sine, 30))};
}

/// For PosedBackbones are made when an object is traced.
struct NoOutline {
    void begin(Point) {}
    void add(const Segment&) {}
    void end(Point, bool) {}
};

}

std::vector<SeenBone> seen_bones(const PosedScene& scene, std::uint32_t skeleton, const Space& space)
{
    const SceneOnPanel& on_panel = scene.on_panel();
    const Sightline see{space, on_panel.camera};
    std::vector<SeenBone> seen;
    std::size_t number = on_panel.scene.first_bone(skeleton);
    for (BoneCursor bones = skeleton_of(on_panel.scene, skeleton).bones(); !bones.at_end(); ++number) {
        const PosedBone& live = on_panel.bones[number];
        seen.push_back({see(live.frame().origin), see(tip_of(bones.next(), live))});
    }
    return seen;
}

std::vector<SeenBackbone> seen_backbones(const PosedScene& scene, const SeenLeaf& leaf)
{
    const ObjectView& object = leaf.item.object;
    if (leaf.item.kind != ItemKind::object || object.deformer != Deformer::backbones)
        return {};
    const SceneOnPanel& on_panel = scene.on_panel();
    NoOutline nothing;
    ObjectStrokes{on_panel, leaf.node}.trace(Affine{}, nothing);
    const std::uint32_t drawing = object.backbones.keys().next().drawing;
    const Sightline see{leaf.space, on_panel.camera};
    std::vector<SeenBackbone> seen;
    bool is_apart = true;
    for (const BackboneNode& node :
         on_panel.backbone_nodes.first(backbone_node_count(on_panel.scene.drawing(drawing)))) {
        const bool is_gap = node.backbone < 0;
        if (!is_gap && is_apart)
            seen.emplace_back();
        is_apart = is_gap;
        if (is_gap)
            continue;
        seen.back().nodes.push_back(see(node.middle));
        seen.back().left.push_back(see(node.left));
        seen.back().right.push_back(see(node.right));
    }
    return seen;
}

}
