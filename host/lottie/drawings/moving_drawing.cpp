#include "host/lottie/drawings/moving_drawing.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <utility>

namespace kfast::lottie {
namespace {

double point_count(const art::Drawing& drawing)
{
    std::size_t count = 1;
    for (const scene::Outline& outline : drawing.outlines)
        count += outline.curves.size() + 1;
    return static_cast<double>(count);
}

}

MovingDrawing moving(art::Animated<art::Drawing> drawing)
{
    MovingDrawing result;
    result.moments.add(drawing);
    const auto shared = std::make_shared<const art::Animated<art::Drawing>>(std::move(drawing));
    for (const auto& key : shared->keys) {
        result.changes_form = result.changes_form || !art::same_form(key.value, shared->keys.front().value);
        result.cost = std::max(result.cost, point_count(key.value));
    }
    result.at = [shared](double time) { return shared->at(time); };
    return result;
}

MovingDrawing together(std::vector<MovingDrawing> drawings)
{
    if (drawings.size() == 1)
        return std::move(drawings.front());
    MovingDrawing result;
    for (const MovingDrawing& drawing : drawings) {
        result.moments.add(drawing.moments);
        result.changes_form = result.changes_form || drawing.changes_form;
        result.cost += drawing.cost;
    }
    const auto parts = std::make_shared<const std::vector<MovingDrawing>>(std::move(drawings));
    result.at = [parts](double time) {
        art::Drawing all;
        for (const MovingDrawing& part : *parts) {
            art::Drawing drawing = part.at(time);
            std::ranges::move(drawing.outlines, std::back_inserter(all.outlines));
        }
        return all;
    };
    return result;
}

}
