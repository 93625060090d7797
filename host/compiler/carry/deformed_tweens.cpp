#include "host/compiler/carry/deformed_tweens.hpp"

#include "core/scene/kfb_limits.hpp"
#include "host/compiler/carry/backbone_timeline.hpp"
#include "host/compiler/carry/cell_crossing.hpp"
#include "host/compiler/carry/outside_points.hpp"
#include "host/compiler/carry/relative_drawing.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace kfast {
namespace {

/// Nothing moves between two keys that these govern.
bool hold(const LawPair& laws)
{
    return laws.x.kind == VelocityLaw::Kind::hold && laws.y.kind == VelocityLaw::Kind::hold;
}

std::size_t point_count(const SegmentDrawing& drawing)
{
    std::size_t points = 0;
    for (const std::vector<Segment>& stroke : drawing)
        points += stroke.size() + 1;
    return points;
}

class Deformation {
public:
    Deformation(const scene::Object& object, Diagnostics& diagnostics)
        : object_{object}, backbones_{object.backbone_keys}, diagnostics_{diagnostics}
    {
    }

    KeyTweens deform(const std::vector<KeyTween>& drawn)
    {
        for (const scene::Key& key : object_.keys)
            warn_of_outside_points(key, cells_at(key.time), diagnostics_);
        add_tweens(drawn);
        KeyTweens deformed{std::move(tweens_), unit_bits_of(relative_)};
        for (std::size_t i = 0; i < deformed.tweens.size(); ++i)
            deformed.tweens[i].ends = {rounded(relative_[2 * i], deformed.unit_bits),
                                       rounded(relative_[2 * i + 1], deformed.unit_bits)};
        return deformed;
    }

private:
    BackboneCells cells_at(Time time) const { return BackboneCells{backbones_.nodes_at(time)}; }

    void add_tweens(const std::vector<KeyTween>& drawn)
    {
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            const KeyTween& tween = drawn[i];
            if (i + 1 == drawn.size() || hold(tween.laws))
                add_still(tween, tween.time);
            else
                add_moving(tween, drawn[i + 1].time);
        }
    }

    void add_still(const KeyTween& tween, Time time)
    {
        const BackboneCells cells = cells_at(time);
        KeyTween still = tween;
        still.time = time;
        still.ends.to = tween.ends.from;
        add(still, cells, cells);
    }

    void add_moving(const KeyTween& tween, Time next)
    {
        KeyTween moving = tween;
        // On its own key an empty drawing is nothing; from there on, strokes grow out of points, which are
        // seen where they have round caps.
        constexpr Time tick{1};
        if (tween.ends.from.strokes.empty() && object_.stroke && tween.time + tick < next) {
            KeyTween nothing = tween;
            nothing.laws = {};
            add_still(nothing, tween.time);
            moving.time = tween.time + tick;
        }
        add(moving, cells_at(tween.time), cells_at(next));
    }

    void add(const KeyTween& tween, const BackboneCells& from, const BackboneCells& to)
    {
        MatchedSegments matched = match_by_count(tween.ends.from, tween.ends.to);
        for (std::vector<SegmentPairs>& parts : matched.strokes)
            for (SegmentPairs& part : parts)
                part = divided_at_cells(part, deforming(from, part, &Pair<Segment>::a),
                                        deforming(to, part, &Pair<Segment>::b));
        auto [a, b] = joined(matched);
        if (std::max(point_count(a), point_count(b)) > kfb::max_drawing_points) {
            report_points(tween.place);
            a = b = {};
        }
        relative_.push_back(relative_drawing(a, from));
        relative_.push_back(relative_drawing(b, to));
        tweens_.push_back(tween);
    }

    static DeformingCells deforming(const BackboneCells& cells, const SegmentPairs& part,
                                    Segment Pair<Segment>::*side)
    {
        return {cells, cells.main_backbone(spots_of(side_of(part, side)))};
    }

    void report_points(SourceSpan place)
    {
        diagnostics_.error(place,
                           "to carry this drawing, backbones divide it into more than " +
                               std::to_string(kfb::max_drawing_points) +
                               " points, as many as a drawing holds",
                           "draw it with fewer points, or use fewer nodes");
    }

    const scene::Object& object_;
    BackboneTimeline backbones_;
    Diagnostics& diagnostics_;
    std::vector<KeyTween> tweens_;
    std::vector<RelativeDrawing> relative_; ///< the two ends of each way
};

}

KeyTweens deformed_tweens(const scene::Object& object, const std::vector<KeyTween>& drawn,
                          Diagnostics& diagnostics)
{
    return Deformation{object, diagnostics}.deform(drawn);
}

}
