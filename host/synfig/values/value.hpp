#pragma once

#include "host/art/geometry/affine.hpp"
#include "host/geometry/outline.hpp"

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace kfast::synfig {

/// As in the file: linear or not, depending on the gamma of the canvas; not limited to 0 to 1.
struct Colour {
    double red = 0;
    double green = 0;
    double blue = 0;
    double alpha = 1;
};

struct GradientStop {
    double position = 0; ///< 0 to 1
    Colour colour;
};

/// Between two stops colours are mixed as by Synfig: what is transparent does not affect the hue.
struct Gradient {
    std::vector<GradientStop> stops; ///< their positions rise; none: black

    Colour at(double position) const;
    /// The mean from 0 to 1; without opacity the hue of the stops.
    Colour mean() const;
};

/// A colour with its channels times its opacity.
Colour weighted(const Colour& colour);
/// The inverse; black where there is no opacity.
Colour unweighted(const Colour& colour);
Colour mixed(const Colour& from, const Colour& to, double share);

using scene::Vec2;

/// A point of a spline. The curve to the next point leaves along leaving() and arrives along its `arriving`,
/// both three times as long as the arms of a Bézier curve.
struct SplinePoint {
    Vec2 vertex;
    double width = 1;
    double origin = 0.5; ///< position between its neighbours where it appears and disappears
    bool split_radius = false;
    bool split_angle = false;
    Vec2 arriving;
    Vec2 second; ///< `split_radius` and `split_angle` say what of it is used

    Vec2 leaving() const;
};

/// How a line goes on beside a width point.
enum class Side { interpolate, round, square, peak, flat, inner_round, inner_peak };

/// Of an outline: how wide it is at a fraction of its length, and how it ends there on either side.
struct WidthPoint {
    double position = 0;
    double width = 1;
    Side before = Side::interpolate;
    Side after = Side::interpolate;
};

/// What a group does to its content, and what some values are moved by: scale and skew, rotation, move.
struct Placement {
    Vec2 offset;
    double angle = 0; ///< degrees, counter-clockwise
    double skew = 0;  ///< degrees by which the second axis is off the perpendicular to the first
    Vec2 scale{1, 1};

    art::Affine matrix() const;
    static Placement of(const art::Affine& matrix);
};

/// A bone at one time, in the coordinates of its canvas, y up.
struct Bone {
    std::string name;
    std::string guid;
    std::string parent; ///< guid, or empty
    art::Affine matrix; ///< from its own coordinates, without its own stretch
    double angle = 0;   ///< degrees, of itself and all its ancestors
    double stretch = 1; ///< of itself, not of its descendants
    double length = 1;
    double width = 0.1;     ///< how far it reaches to either side where it begins
    double tip_width = 0.1; ///< and where it ends
    double depth = 0;

    Vec2 from() const { return {matrix.e, matrix.f}; }
    Vec2 to() const;
    /// The matrix of points that are linked to the bone.
    art::Affine carrying() const;
};

/// Names a bone of the file.
struct BoneName {
    std::string guid;
};

struct Value;

struct List {
    std::vector<Value> entries;
    bool loop = false;
};

/// What a value node is at one time. Numbers are reals, integers, angles in degrees, and times in seconds.
struct Value {
    std::variant<std::monostate, bool, double, Vec2, Colour, Gradient, std::string, SplinePoint, WidthPoint,
                 Placement, Bone, BoneName, List>
        held;

    /// The value of that type, or a default if it has another type.
    template <typename Held>
    Held as(Held default_value = {}) const
    {
        const Held* found = std::get_if<Held>(&held);
        return found ? *found : std::move(default_value);
    }
    double number(double default_value = 0) const;
    bool truth(bool default_value = false) const;
};

/// By the number that files have for it; Side::flat for unknown numbers.
Side side_of(double number);

/// The sum of numbers, points and colours; for other values the first.
Value sum(const Value& left, const Value& right);
Value difference(const Value& left, const Value& right);
Value product(const Value& value, double factor);

/// The width in between a list of width points, sorted or not, linear from one to the next; `default_value`
/// if there are none.
double width_at(const List& points, double position, double default_value);

}
