#pragma once

#include "host/synfig/reading/layer.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace kfast::synfig {

/// How a layer is imported by its blend method.
enum class Blending {
    normal,
    behind,    ///< painted below all that is below it
    tinting,   ///< changes the colours of all that is below it, and paints nothing
    replacing, ///< painted instead of all that is below it
    left_out,
};

/// How far a layer reaches.
enum class Extent { shape, everywhere };

/// Adds a loss if that is not what the layer asks for. `lies_lowest`: nothing in its canvas is below.
Blending blending_of(const Layer& layer, Extent extent, bool lies_lowest);

/// Whether a layer is painted normally.
bool is_composite(const Layer& layer);
/// Whether a layer erases, and shows nothing of its own.
bool takes_away(const Layer& layer);

/// The effect of a tinting layer of one colour on a colour; opacities stay.
using Tinting = Colour (*)(const Colour& below, const Colour& above, double amount);
/// Null for methods that do not tint.
Tinting tinting_of(const Layer& layer);

/// The effect of a layer over everything on the colours below it. It has one colour: a gradient has its
/// mean.
class Tint {
public:
    /// For a layer whose blend method tints.
    explicit Tint(const Layer& layer) : layer_{layer}, tinting_{tinting_of(layer)} {}
    /// For a group of nothing but such a cover, which blends as the group does.
    Tint(const Layer& group, const Layer& cover) : layer_{cover}, group_{group}, tinting_{tinting_of(group)}
    {
    }

    void apply(std::vector<art::Node>& nodes) const;

private:
    void apply(art::Animated<art::Rgb>& colour) const;
    art::Rgb applied(const art::Rgb& below, double frame) const;
    double amount(double frame) const;

    Layer layer_;
    std::optional<Layer> group_;
    Tinting tinting_;
};

}
