#include "host/synfig/deformation_layer.hpp"

namespace kfast::synfig {

std::vector<art::Node> deformed(const Layer& layer, std::vector<art::Node> nodes)
{
    layer.lose("skeleton deformation", "nothing is deformed");
    return nodes;
}

}
