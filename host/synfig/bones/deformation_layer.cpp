#include "host/synfig/bones/deformation_layer.hpp"

#include "host/synfig/bones/bone_field.hpp"
#include "host/synfig/bones/deformable_shapes.hpp"
#include "host/synfig/bones/posed_rig.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace kfast::synfig {
namespace {

// Pixels by which a curve between two deformed points may differ from the one deformed throughout.
constexpr double bend_tolerance = 0.25;
constexpr std::size_t max_bones_of_point = 4;

class Deformation {
public:
    Deformation(const Layer& layer, const BoneField& field) : layer_{layer}, field_{field}
    {
        if (field.keeps_lengths()) {
            rig_ = posed_rig(
                {layer.name(), [&](double frame) { return field.pairs_at(frame); }, layer.bends({"bones"})},
                layer.reading());
            rig_index_ = layer.reading().rigs.size();
            layer.reading().rigs.push_back(rig_->rig);
        }
    }

    void deform(std::vector<art::Node>& nodes)
    {
        for (art::Node& node : nodes)
            if (auto* group = std::get_if<art::Group>(&node.content))
                deform(group->nodes);
            else
                deform(node, std::get<art::Shape>(node.content));
    }

private:
    void deform(const art::Node& node, art::Shape& shape)
    {
        if (shape.drawing.keys.front().value.outlines.empty())
            return;
        for (auto& key : shape.drawing.keys)
            for (scene::Outline& outline : key.value.outlines)
                close_by_line(outline);
        const art::Drawing first = shape.drawing.keys.front().value;
        const Division division = division_of(first);
        const bool same_forms = std::ranges::all_of(
            shape.drawing.keys, [&](const auto& key) { return art::same_form(key.value, first); });
        if (rig_ && same_forms) {
            for (auto& key : shape.drawing.keys)
                key.value = divided(key.value, division);
            shape.skin = skin_of(node, shape.drawing.keys.front().value);
        } else {
            bake(shape, division, same_forms);
        }
    }

    /// So that the closing segment can bend as well.
    static void close_by_line(scene::Outline& outline)
    {
        const Vec2 last = outline.curves.empty() ? outline.from : outline.curves.back().to;
        if (outline.closed && scene::distance(last, outline.from) > 0)
            outline.curves.push_back(scene::line_to(outline.from));
    }

    /// Where each curve is divided so that it bends as it should.
    Division division_of(const art::Drawing& drawing) const
    {
        const auto samples = field_.samples();
        return division(drawing, bend_tolerance, [&](const scene::Curve& curve, Vec2 from) {
            double worst = 0;
            for (const double frame : samples)
                worst = std::max(worst, bend_error(curve, from, frame));
            return worst;
        });
    }

    /// How far a curve that is deformed at its ends alone is from where its inside should be.
    double bend_error(const scene::Curve& curve, Vec2 from, double frame) const
    {
        const art::Affine begin = carrying(from, frame);
        const art::Affine end = carrying(curve.to, frame);
        const scene::Curve carried = scene::cubic_to(begin.of(curve.c1), end.of(curve.c2), end.of(curve.to));
        double worst = 0;
        for (const double share : {0.25, 0.5, 0.75})
            worst = std::max(worst, scene::distance(spot_on(carried, begin.of(from), share),
                                                    field_.deformed(spot_on(curve, from, share), frame)));
        return worst;
    }

    /// The mean of the bones' matrices at a point; the identity if there is none.
    art::Affine carrying(Vec2 place, double frame) const
    {
        art::Affine total{0, 0, 0, 0, 0, 0};
        double weights = 0;
        for (const art::BoneInfluence& share : field_.shares(place)) {
            const art::Affine one = field_.carrying(share.bone, frame);
            total = {total.a + share.weight * one.a, total.b + share.weight * one.b,
                     total.c + share.weight * one.c, total.d + share.weight * one.d,
                     total.e + share.weight * one.e, total.f + share.weight * one.f};
            weights += share.weight;
        }
        if (weights <= 0)
            return {};
        return {total.a / weights, total.b / weights, total.c / weights,
                total.d / weights, total.e / weights, total.f / weights};
    }

    art::Skin skin_of(const art::Node& node, const art::Drawing& drawing)
    {
        art::Skin skin;
        skin.rig = rig_index_;
        skin.turns_changes = true;
        for (const Vec2 spot : points_of(drawing))
            skin.points.push_back(shares_in_rig(node, spot));
        return skin;
    }

    std::vector<art::BoneInfluence> shares_in_rig(const art::Node& node, Vec2 spot)
    {
        if (!field_.covers(spot))
            layer_.reading().losses.add(
                {"part outside of the bones",
                 layer_.scope().path.empty() ? node.name : layer_.scope().path + " / " + node.name,
                 {},
                 "it is not cut off, and goes with the bones"});
        std::vector<art::BoneInfluence> shares = field_.shares(spot);
        if (shares.empty())
            shares.push_back({field_.nearest(spot), 1});
        std::ranges::stable_sort(shares, std::ranges::greater{}, &art::BoneInfluence::weight);
        shares.resize(std::min(shares.size(), max_bones_of_point));
        // Exactly on a bone its weight is unbounded.
        const double max = shares.front().weight;
        for (art::BoneInfluence& share : shares) {
            share.bone = rig_->place[share.bone];
            share.weight /= max;
        }
        std::erase_if(shares, [](const art::BoneInfluence& share) { return share.weight < 1.0 / 1024; });
        return shares;
    }

    void bake(art::Shape& shape, const Division& division, bool same_forms) const
    {
        std::vector<double> times = layer_.bends({"bones"});
        for (const auto& key : shape.drawing.keys)
            times.push_back(key.time);
        const art::Animated<art::Drawing> before = shape.drawing;
        const std::function<art::Drawing(double)> drawing = [&](double frame) {
            const art::Drawing here = before.at(frame);
            return carried(same_forms ? divided(here, division) : here, frame);
        };
        shape.drawing = traced(drawing, {0, layer_.reading().frames, std::move(times), baked_tolerance,
                                         &layer_.reading().budget});
    }
    static constexpr double baked_tolerance = 1.0 / 32;

    art::Drawing carried(art::Drawing drawing, double frame) const
    {
        for (scene::Outline& outline : drawing.outlines) {
            art::Affine begin = carrying(outline.from, frame);
            outline.from = begin.of(outline.from);
            for (scene::Curve& curve : outline.curves) {
                const art::Affine end = carrying(curve.to, frame);
                curve = curve.cubic ? scene::cubic_to(begin.of(curve.c1), end.of(curve.c2), end.of(curve.to))
                                    : scene::line_to(end.of(curve.to));
                begin = end;
            }
        }
        return drawing;
    }

    const Layer& layer_;
    const BoneField& field_;
    std::optional<PosedRig> rig_;
    std::size_t rig_index_ = 0;
};

}

std::vector<art::Node> deformed(const Layer& layer, std::vector<art::Node> nodes)
{
    const BoneField field{layer};
    if (field.size() == 0) {
        layer.lose("skeleton deformation without bones", "nothing is deformed");
        return nodes;
    }
    flatten(nodes, layer);
    Deformation{layer, field}.deform(nodes);
    return nodes;
}

}
