#include "host/preview/painted_items.hpp"

#include "core/sweep.hpp"

#include <span>

namespace kfast {
namespace {

constexpr int half_covered = 128; ///< of 255

}

PaintedItems::PaintedItems(const SceneView& scene, Size panel, Fit fit)
    : ToldPlayer{scene, panel, fit}, cells_(CoverageRow::cells_for(panel.width))
{
}

std::optional<std::uint32_t> PaintedItems::path_at(Time moment, int x, int y)
{
    const Size panel = player().panel();
    if (x < 0 || y < 0 || x >= panel.width || y >= panel.height)
        return {};
    player().show_moment(moment);
    std::optional<std::uint32_t> touched;
    const std::span<const PaintStep> steps = player().picture().steps();
    for (auto step = steps.rbegin(); step != steps.rend(); ++step) {
        if (step->kind != PaintStep::Kind::layer || step->layer.colour.opacity == 0)
            continue;
        const int level = level_at(*step, x, y);
        if (level >= half_covered)
            return step->item;
        if (level > 0 && !touched)
            touched = step->item;
    }
    return touched;
}

/// Sweeps copies: they begin with the first row, and what they change in the store is set up anew then.
int PaintedItems::level_at(const PaintStep& step, int x, int y)
{
    Layer layer = step.layer;
    if (!layer.reaches(y) || x < layer.left || x >= layer.right)
        return 0;
    layer.rewind();
    OutlineStore outlines = player().picture().outlines;
    CoverageRow coverage{cells_, player().panel().width};
    sweep_row(outlines, layer, y, coverage);
    int found = 0;
    coverage.take_spans([&](int begin, int end, int level) {
        if (x >= begin && x < end)
            found = level;
    });
    return found;
}

}
