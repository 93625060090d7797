#include "host/preview/overlay/painted_items.hpp"

#include <span>

namespace kfast {
namespace {

constexpr int half_covered = raster::full_coverage / 2;

}

PaintedItems::PaintedItems(const SceneView& scene, Size panel, Fit fit)
    : StandalonePlayer{scene, panel, fit}, probe_{player()}
{
}

std::optional<std::uint32_t> PaintedItems::path_at(Time moment, int x, int y)
{
    const Size panel = player().panel();
    if (x < 0 || y < 0 || x >= panel.width || y >= panel.height)
        return {};
    player().show_moment(moment);
    std::optional<std::uint32_t> touched;
    const std::span<const raster::PaintStep> steps = player().picture().steps();
    for (std::size_t number = steps.size(); number-- != 0;) {
        const raster::PaintStep& step = steps[number];
        if (step.kind != raster::PaintStep::Kind::layer || step.colour.opacity == 0)
            continue;
        const int coverage = probe_.coverage(number, x, y);
        if (coverage >= half_covered)
            return step.item;
        if (coverage > 0 && !touched)
            touched = step.item;
    }
    return touched;
}

}
