#pragma once

#include "host/synfig/layers/blending.hpp"

#include <optional>
#include <vector>

namespace kfast::synfig {

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
