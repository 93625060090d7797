#pragma once

#include "host/art/document/document.hpp"

namespace kfast::art {

/// A value tweened between two others. Both must outlive it.
template <typename Value>
struct OnWay {
    const Value& from;
    const Value& to;
    double share = 0;
};

/// How far two values are from each other: for numbers the difference, for colours that of the channel that
/// differs most, for drawings that of the points and control points that are farthest apart.
double distance(const OnWay<double>& left, const OnWay<double>& right);
double distance(const OnWay<Rgb>& left, const OnWay<Rgb>& right);
/// All drawings must have the same form.
double distance(const OnWay<Drawing>& left, const OnWay<Drawing>& right);

template <typename Value>
double distance(const Value& left, const Value& right)
{
    return distance(OnWay<Value>{left, left, 0}, OnWay<Value>{right, right, 0});
}

/// The progress between two values at which they come nearest to a third; 0 if they are equal.
double nearest_share(const double& from, const double& to, const OnWay<double>& value);
double nearest_share(const Rgb& from, const Rgb& to, const OnWay<Rgb>& value);
double nearest_share(const Drawing& from, const Drawing& to, const OnWay<Drawing>& value);

/// Whether one can be tweened into the other, point by point.
inline bool same_form(double, double) { return true; }
inline bool same_form(const Rgb&, const Rgb&) { return true; }

}
