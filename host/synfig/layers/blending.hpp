#pragma once

#include "host/synfig/reading/layer.hpp"

#include <functional>
#include <optional>
#include <vector>

namespace kfast::synfig {

/// What becomes of a layer because of its blend method.
enum class Blending {
    normal,
    behind,    ///< painted below all that lies below it
    tinting,   ///< changes the colours of all that lies below it, and paints nothing
    replacing, ///< painted instead of all that lies below it
    left_out,
};

/// How far a layer reaches.
enum class Extent { shape, everywhere };

/// Adds a loss where that is not what the layer asks for. `lies_lowest`: nothing in its canvas is below.
Blending blending_of(const Layer& layer, Extent extent, bool lies_lowest);

/// Whether a layer is painted the ordinary way.
bool is_composite(const Layer& layer);
/// Such a layer shows nothing of its own.
bool takes_away(const Layer& layer);

/// What a layer that tints makes of a colour when it is all in one colour; opacities stay.
using Tinting = Colour (*)(const Colour& below, const Colour& above, double amount);
/// Nothing for methods that do not tint.
Tinting tinting_of(const Layer& layer);

/// What a layer over everything makes of the colours below it. It is all in one colour: a gradient is in its
/// mean.
class Tint {
public:
    /// Of a layer whose blend method tints.
    explicit Tint(const Layer& layer) : layer_{layer}, tinting_{tinting_of(layer)} {}
    /// Of a group of nothing but such a cover, which blends as the group does.
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
