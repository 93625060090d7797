#pragma once

#include "host/art/animation/animated.hpp"
#include "host/art/document/document.hpp"
#include "host/art/geometry/drawing.hpp"
#include "host/geometry/outline.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace kfast::art {

/// The range of progress that a tween between two neighbouring keys comes to.
struct TweenRange {
    std::size_t from = 0; ///< index of its first key
    std::size_t to = 0;
    double low = 0;
    double high = 0;
};

/// All tweens of an animation; for a still one, a tween that stays at its key.
std::vector<TweenRange> tweens_of(const Animated<Drawing>& drawing);

/// What an error of 1 in all keys may become between them: above 1 only where eases overshoot their keys.
double tween_growth(std::span<const TweenRange> tweens);

/// A vector that changes linearly.
struct TweenedVector {
    scene::Vec2 begin;
    scene::Vec2 way;
    scene::Vec2 end() const { return begin + way; }
};

/// The greatest angle in radians, never too small, between two vectors while their progress is `low` to
/// `high`. A half turn where one of them may vanish alone or they may be opposed.
double greatest_turn(const TweenedVector& left, const TweenedVector& right, double low, double high);

/// The smallest length, never too great, of a vector in that range.
double shortest(const TweenedVector& vector, double low, double high);

/// The greatest angle in radians, never too small, between two vectors that are tweened: `left` and `right`
/// have one of each for every key. A half turn where one of them may vanish or they may be opposed.
double greatest_turn(std::span<const scene::Vec2> left, std::span<const scene::Vec2> right,
                     std::span<const TweenRange> tweens);

/// The smallest length, never too great, of a vector that is tweened.
double shortest(std::span<const scene::Vec2> vectors, std::span<const TweenRange> tweens);

/// A direction of a drawing that its line shows: of what meets at a corner, or of an end.
struct CornerArm {
    std::vector<scene::Vec2> directions; ///< in each key; as long as the handle that gives it
    double factor = 1; ///< how far what is visible moves when the arm rotates, in half widths per radian
};

/// The arms of a shape whose drawings all have the same form. Round joins and caps show none, nor do joins
/// that are smooth at all times.
std::vector<CornerArm> corner_arms(const Shape& shape);

/// How far the visible line moves, at most, when points of the drawing move by 1, at any time: at least 1,
/// and infinite where an arm vanishes.
double corner_motion(std::span<const CornerArm> arms, std::span<const TweenRange> tweens, double half_width);

}
