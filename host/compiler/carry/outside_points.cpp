#include "host/compiler/carry/outside_points.hpp"

#include "host/compiler/carry/relative_drawing.hpp"
#include "host/text/counted.hpp"

#include <cstddef>
#include <sstream>
#include <string>

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
    /// Returns the backbone that carries the point.
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

    /// Control points may lie anywhere, as long as they can be carried.
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
    std::size_t moved_ = 0; ///< of them, because they cannot be carried where they are
    Vec2 first_;            ///< of them
};

}

void warn_of_outside_points(const scene::Key& key, const BackboneCells& cells, Diagnostics& diagnostics)
{
    OutsidePoints points{cells};
    for (const std::vector<Segment>& stroke : joined(match_by_count(key.drawing, key.drawing)).a)
        points.look_at(stroke);
    points.warn(key.place, diagnostics);
}

}
