#include "host/compiler/carry/carried_ways.hpp"

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

class Carrying {
public:
    Carrying(const scene::Object& object, Diagnostics& diagnostics)
        : object_{object}, backbones_{object.backbone_keys}, diagnostics_{diagnostics}
    {
    }

    KeyWays carry(const std::vector<KeyWay>& drawn)
    {
        for (const scene::Key& key : object_.keys)
            warn_of_outside_points(key, cells_at(key.time), diagnostics_);
        add_ways(drawn);
        KeyWays carried{std::move(ways_), unit_bits_of(relative_)};
        for (std::size_t i = 0; i < carried.ways.size(); ++i)
            carried.ways[i].ends = {rounded(relative_[2 * i], carried.unit_bits),
                                    rounded(relative_[2 * i + 1], carried.unit_bits)};
        return carried;
    }

private:
    BackboneCells cells_at(Time time) const { return BackboneCells{backbones_.nodes_at(time)}; }

    void add_ways(const std::vector<KeyWay>& drawn)
    {
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            const KeyWay& way = drawn[i];
            if (i + 1 == drawn.size() || hold(way.laws))
                add_still(way, way.time);
            else
                add_moving(way, drawn[i + 1].time);
        }
    }

    void add_still(const KeyWay& way, Time time)
    {
        const BackboneCells cells = cells_at(time);
        KeyWay still = way;
        still.time = time;
        still.ends.to = way.ends.from;
        add(still, cells, cells);
    }

    void add_moving(const KeyWay& way, Time next)
    {
        KeyWay moving = way;
        // On its own key an empty drawing is nothing; from there on, strokes grow out of points, which are
        // seen where they have round caps.
        constexpr Time tick{1};
        if (way.ends.from.strokes.empty() && object_.stroke && way.time + tick < next) {
            KeyWay nothing = way;
            nothing.laws = {};
            add_still(nothing, way.time);
            moving.time = way.time + tick;
        }
        add(moving, cells_at(way.time), cells_at(next));
    }

    void add(const KeyWay& way, const BackboneCells& from, const BackboneCells& to)
    {
        MatchedSegments matched = match_by_count(way.ends.from, way.ends.to);
        for (std::vector<SegmentPairs>& parts : matched.strokes)
            for (SegmentPairs& part : parts)
                part = divided_at_cells(part, carrying(from, part, &Pair<Segment>::a),
                                        carrying(to, part, &Pair<Segment>::b));
        auto [a, b] = joined(matched);
        if (std::max(point_count(a), point_count(b)) > kfb::max_drawing_points) {
            report_points(way.place);
            a = b = {};
        }
        relative_.push_back(relative_drawing(a, from));
        relative_.push_back(relative_drawing(b, to));
        ways_.push_back(way);
    }

    static CarryingCells carrying(const BackboneCells& cells, const SegmentPairs& part,
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
    std::vector<KeyWay> ways_;
    std::vector<RelativeDrawing> relative_; ///< the two ends of each way
};

}

KeyWays carried_ways(const scene::Object& object, const std::vector<KeyWay>& drawn, Diagnostics& diagnostics)
{
    return Carrying{object, diagnostics}.carry(drawn);
}

}
