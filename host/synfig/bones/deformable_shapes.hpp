#pragma once

#include "host/art/geometry/drawing.hpp"
#include "host/synfig/reading/layer.hpp"

#include <functional>
#include <vector>

namespace kfast::synfig {

/// At which parameters each curve is divided, outline by outline, curve by curve. Lines that are divided
/// become curves.
using Division = std::vector<std::vector<std::vector<double>>>;

/// Halves curves until `error`, of a cubic and its start, is within the tolerance, at most into 16.
Division division(const art::Drawing& drawing, double tolerance,
                  const std::function<double(const scene::Curve&, scene::Vec2)>& error);

/// The same picture with more points. The drawing has the form of the one that was examined.
art::Drawing divided(const art::Drawing& drawing, const Division& division);

scene::Vec2 spot_on(const scene::Curve& cubic, scene::Vec2 from, double share);

/// Points as skins count them: where outlines begin, and where their curves end, but for the closing point.
std::vector<scene::Vec2> points_of(const art::Drawing& drawing);

/// Bakes the motion of groups and shapes into the drawings of the shapes, so that all of them are in the
/// coordinates of the nodes. Names, opacities and visibility stay.
void flatten(std::vector<art::Node>& nodes, const Layer& layer);

}
