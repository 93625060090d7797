#pragma once

#include "host/preview/overlay/overlay.hpp"
#include "host/preview/overlay/posed_scene.hpp"
#include "host/preview/overlay/seen_strokes.hpp"

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace kfast {

/// Where labels are on a picture, so that none overlaps another.
class LabelPlaces {
public:
    static constexpr std::size_t max = 400;

    /// `scale` is how many pixels of a window a pixel of the panel takes.
    explicit LabelPlaces(double scale) : scale_{scale} {}

    /// Takes the room for a text at `at`, if it is free and there are not too many.
    bool take(PanelSpot at, const std::string& text);

private:
    double scale_;
    std::size_t count_ = 0;
    std::set<std::pair<int, int>> cells_; ///< the cells that are taken, of the size of a letter
};

/// Adds what is visible of a scene to an overlay, leaf by leaf. No more lines and dots than a person could
/// tell apart: further ones are left out.
class OverlayMarks {
public:
    static constexpr std::size_t max_lines = 20'000;
    static constexpr std::size_t max_dots = 4'000;

    OverlayMarks(const Viewport& viewport, const PosedScene& scene, double scale, Overlay& overlay)
        : viewport_{viewport}, scene_{scene}, places_{scale}, overlay_{overlay}
    {
    }

    /// The bones or backbones that deform it; a skeleton that deforms several leaves in one place once.
    void add_bones(const SeenLeaf& leaf);
    /// Skeletons that have deformed no leaf yet, as they are on the canvas.
    void add_other_bones();
    void add_outline(const SeenLeaf& leaf) { add_outline(seen_strokes(scene_, leaf)); }
    /// The outline, the points and their numbers, the control points and the numbers of strokes. Numbers
    /// begin with 1.
    void add_numbers(const SeenLeaf& leaf);

private:
    void add_bones(std::uint32_t skeleton, const Space& space);
    void add_outline(const std::vector<SeenStroke>& strokes);
    void add_points(const SeenStroke& stroke);
    void add_number(const SeenStroke& stroke, std::size_t number);
    void add_line(Point from, Point to, MarkKind kind);
    void add_lines(const std::vector<Point>& points, MarkKind kind);
    void add_dot(Point at, MarkKind kind);
    bool add_label(PanelSpot at, std::size_t number, MarkKind kind);

    const Viewport& viewport_;
    const PosedScene& scene_;
    LabelPlaces places_;
    Overlay& overlay_;
    std::set<std::tuple<std::uint32_t, Fixed, Fixed, Fixed, Fixed>>
        skeletons_;                     ///< drawn, by their first bones
    std::set<std::uint32_t> deformers_; ///< drawn anywhere
};

}
