#include "host/compiler/carry/deformed_tweens.hpp"

#include "core/scene/kfb_limits.hpp"
#include "host/compiler/carry/backbone_cells.hpp"
#include "host/compiler/carry/backbone_timeline.hpp"
#include "host/compiler/carry/relative_drawing.hpp"
#include "host/scene/model.hpp"
#include "host/text/diagnostic.hpp"
#include "host/text/number_text.hpp"

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <utility>

namespace kfast {

namespace {

std::string text_of(Vec2 spot)
{
    std::ostringstream text;
    text << spot.x << ' ' << spot.y;
    return text.str();
}

class OutsidePoints {
public:
    explicit OutsidePoints(const BackboneCells& cells) : cells_{cells} {}

    void look_at(const std::vector<Segment>& stroke)
    {
        const std::int32_t main = cells_.main_backbone(spots_of(stroke));
        std::int32_t backbone = look_at(stroke.front().from, main);
        for (const Segment& segment : stroke) {
            // The closing point of a stroke has been looked at.
            const bool closes = &segment == &stroke.back() && segment.to == stroke.front().from;
            const std::int32_t next =
                closes ? cells_.place_of(in_pixels(segment.to), main).backbone : look_at(segment.to, main);
            if (segment.kind == Segment::Kind::cubic) {
                look_at_control(segment.c1, backbone);
                look_at_control(segment.c2, next);
            }
            backbone = next;
        }
    }

    void warn(SourceSpan place, Diagnostics& diagnostics) const
    {
        if (outside_ == 0)
            return;
        std::string message = counted(outside_, "point") + " of this drawing " +
                              (outside_ == 1 ? "lies" : "lie") + " outside of the skeleton, the first at " +
                              text_of(first_);
        if (moved_ > 0)
            message += "; " + counted(moved_, "point") + " had to be moved to its edge";
        diagnostics.warning(
            place, message,
            "make the skeleton wider or longer; until then, the nearest segment carries them");
    }

private:
    /// Returns the backbone that deforms the point.
    std::int32_t look_at(Point point, std::int32_t main)
    {
        constexpr double rounding = 1.0 / 8; // px
        const RelativePoint place = cells_.place_of(in_pixels(point), main);
        if (place.distance > rounding)
            add(point);
        if (place.distance > rounding && !place.is_deformed)
            ++moved_;
        return place.backbone;
    }

    /// Control points may be anywhere, as long as they can be deformed.
    void look_at_control(Point point, std::int32_t backbone)
    {
        if (cells_.place_on(in_pixels(point), backbone).is_deformed)
            return;
        add(point);
        ++moved_;
    }

    void add(Point point)
    {
        if (outside_ == 0)
            first_ = in_pixels(point);
        ++outside_;
    }

    const BackboneCells& cells_;
    std::size_t outside_ = 0;
    std::size_t moved_ = 0; ///< of them, because they cannot be deformed where they are
    Vec2 first_;            ///< of them
};

/// Warns of the points of a key's drawing that are in none of `cells`, which are those at its time. Less than
/// 1/8 px outside, as from rounding, does not count.
void warn_of_outside_points(const scene::Key& key, const BackboneCells& cells, Diagnostics& diagnostics)
{
    OutsidePoints points{cells};
    for (const std::vector<Segment>& stroke : joined(match_by_count(key.drawing, key.drawing)).a)
        points.look_at(stroke);
    points.warn(key.place, diagnostics);
}

/// Whether nothing moves between two keys that these govern.
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
        // On its own key an empty drawing is nothing; after that, strokes grow out of points, which are
        // visible if they have round caps.
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
    std::vector<RelativeDrawing> relative_; ///< the two ends of each tween
};

}

KeyTweens deformed_tweens(const scene::Object& object, const std::vector<KeyTween>& drawn,
                          Diagnostics& diagnostics)
{
    return Deformation{object, diagnostics}.deform(drawn);
}

}
