#include "host/compiler/carry/backbone_cells.hpp"

#include <algorithm>
#include <cmath>

namespace kfast {

BackboneCells::BackboneCells(std::span<const BackboneNode> nodes)
{
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (nodes[i].backbone >= 0 && (i == 0 || nodes[i - 1].backbone < 0))
            add_cells(nodes, i);
}

void BackboneCells::add_cells(std::span<const BackboneNode> nodes, std::size_t first)
{
    const std::int32_t backbone = nodes[first].backbone;
    std::size_t last = first;
    while (nodes[last + 1].backbone >= 0) // a gap is behind each backbone
        ++last;
    reaches_.push_back({static_cast<double>(first), static_cast<double>(last)});
    for (std::size_t i = first; i < last; ++i) {
        const double begin = i == first ? -1 : 0;
        const double end = i + 1 == last ? 2 : 1;
        const auto along = static_cast<double>(i);
        cells_.push_back({{nodes[i], nodes[i + 1], &BackboneNode::left, begin, end}, along, 1, backbone});
        cells_.push_back({{nodes[i], nodes[i + 1], &BackboneNode::right, begin, end}, along, -1, backbone});
    }
}

RelativePoint BackboneCells::in_cell(const Cell& cell, CellPlace place) const
{
    return {.along = cell.begin + place.along,
            .across = cell.sign * place.across,
            .backbone = cell.backbone,
            .limit = reach(cell.backbone).last_node + 1};
}

RelativePoint BackboneCells::place_of(Vec2 spot, std::optional<std::int32_t> preferred) const
{
    const Cell* cell = preferred ? containing(spot, preferred) : nullptr;
    if (cell == nullptr)
        cell = containing(spot, std::nullopt);
    if (cell == nullptr)
        return nearest(spot, std::nullopt);
    return in_cell(*cell, *cell->shape.place_of(spot));
}

RelativePoint BackboneCells::place_on(Vec2 spot, std::int32_t backbone) const
{
    if (containing(spot, backbone) != nullptr)
        return place_of(spot, backbone);
    return nearest(spot, backbone);
}

std::int32_t BackboneCells::main_backbone(std::span<const Vec2> spots) const
{
    std::vector<std::size_t> inside(reaches_.size(), 0);
    for (std::size_t i = 0; i < inside.size(); ++i)
        inside[i] = static_cast<std::size_t>(std::ranges::count_if(
            spots, [&](Vec2 spot) { return containing(spot, static_cast<std::int32_t>(i)) != nullptr; }));
    return static_cast<std::int32_t>(std::ranges::max_element(inside) - inside.begin());
}

const BackboneCells::Cell* BackboneCells::containing(Vec2 spot, std::optional<std::int32_t> backbone) const
{
    const auto cell = std::ranges::find_if(cells_, [&](const Cell& candidate) {
        if ((backbone && candidate.backbone != *backbone) || !candidate.shape.may_contain(spot))
            return false;
        const auto place = candidate.shape.place_of(spot);
        return place && is_inside(*place);
    });
    return cell == cells_.end() ? nullptr : &*cell;
}

RelativePoint BackboneCells::nearest(Vec2 spot, std::optional<std::int32_t> backbone) const
{
    RelativePoint best;   // that reaches to the spot
    RelativePoint beside; // that does not
    best.distance = beside.distance = HUGE_VAL;
    for (const Cell& cell : cells_) {
        if (backbone && cell.backbone != *backbone)
            continue;
        const CellPlace edge = cell.shape.nearest(spot);
        const double away = distance(cell.shape.spot_at(edge), spot);
        const auto place = cell.shape.place_of(spot);
        RelativePoint& found = place ? best : beside;
        if (away >= found.distance)
            continue;
        found = in_cell(cell, place.value_or(edge));
        found.distance = away;
        found.is_deformed = place.has_value();
    }
    return best.distance < HUGE_VAL ? best : beside;
}

}
