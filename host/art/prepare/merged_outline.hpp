#pragma once

#include "host/art/geometry/curves.hpp"
#include "host/art/prepare/tween_turn.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace kfast::art {

/// What preserves the directions of an outline: the edge of a line along it; no value is 0 if there is a line
/// with corners or ends that show them.
struct OutlineEdge {
    double half_width = 0;
    double corner_factor = 1; ///< how far a tip may move when its arm rotates, in half widths per radian
    double tolerance = 0;
};

/// Merges the segments of one outline in all of its keys at once.
///
/// Every segment is a cubic, and in all keys the same segments become one, with the same fractions of its
/// parameter. So the error at a parameter is, in a tween, the mix of the errors in its keys; what is within
/// the tolerance in all keys is so between them, and where an ease overshoots its keys the tolerance is
/// divided by how much that can enlarge the errors. Where a line along the outline shows its directions, they
/// rotate by no more than its edge allows; if need be, not at all.
class MergedOutline {
public:
    /// One outline for each key, all of the same form.
    MergedOutline(std::vector<scene::Outline*> outlines, std::span<const TweenRange> tweens, double tolerance,
                  const OutlineEdge& edge);

    /// Merges, and writes into the outlines.
    void write();

private:
    /// Segments from `begin` on that become one, in every key.
    struct Run {
        std::size_t begin = 0;
        std::size_t end = 0;
        bool straight = false;
        std::vector<CubicPiece> pieces; ///< of each key
    };

    /// Whether those of a new segment may rotate, or keep the directions of the segments that it replaces.
    enum class Handles { free, kept };

    void read();
    void drop_points();
    void straighten();
    bool is_straight(std::size_t segment) const;
    void find_joins();
    bool can_merge_at(std::size_t segment);
    Run best_run(std::size_t begin) const;
    template <typename Attempt>
    std::optional<Run> longest(std::size_t begin, const Attempt& attempt) const;
    std::optional<Run> line(std::size_t begin, std::size_t end) const;
    std::optional<Run> curve(std::size_t begin, std::size_t end) const;
    std::vector<double> shares(std::size_t begin, std::size_t end) const;
    std::optional<Run> curve(std::size_t begin, std::size_t end, Handles handles) const;
    CubicPiece fitted(std::size_t key, std::size_t begin, const std::vector<double>& shares,
                      Handles handles) const;
    bool keeps_ends(const Run& run) const;
    bool turns_little(std::span<const scene::Vec2> before, std::span<const scene::Vec2> now,
                      double factor) const;
    double end_growth(std::size_t segment) const;
    int saved(const Run& run) const;
    bool has_edge() const { return edge_.half_width > 0; }
    std::size_t count() const { return straight_.size(); }
    template <typename Direction>
    std::vector<scene::Vec2> directions(std::size_t segment, const Direction& direction) const;

    std::vector<scene::Outline*> outlines_;
    std::span<const TweenRange> tweens_;
    double tolerance_; ///< in keys
    OutlineEdge edge_;
    std::vector<std::vector<CubicPiece>> pieces_; ///< by key, then by segment
    std::vector<bool> straight_;                  ///< whether a segment is a line in all keys
    /// How much of the parameter a segment takes, relative to the one before it; 0 if they are not merged.
    std::vector<double> widths_;
    std::vector<std::size_t> smooth_until_; ///< by segment: where merging must end
};

}
