#include "host/compiler/carry/backbone_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace kfast {

namespace {

constexpr double widest = 8; ///< across, the most that the format holds
/// What rounding adds to a position, in fractions of a cell.
constexpr double noise = 1e-7;

/// The real solutions of a x^2 + b x + c = 0; none, one or two.
struct Roots {
    std::array<double, 2> roots{};
    std::size_t count = 0;

    void add(double root) { roots[count++] = root; }
};

Roots roots_of(double a, double b, double c)
{
    Roots roots;
    const double square = b * b - 4 * a * c;
    if (square < 0)
        return roots;
    const double sum = -0.5 * (b + std::copysign(std::sqrt(square), b)); // no two terms that cancel
    if (sum == 0) {
        if (c == 0)
            roots.add(0);
        return roots;
    }
    roots.add(c / sum);
    if (a != 0)
        roots.add(sum / a);
    return roots;
}

/// The fraction of the line from `a` to `b` at which it is nearest to `spot`.
double nearest_share(Vec2 a, Vec2 b, Vec2 spot)
{
    const Vec2 way = b - a;
    const double square = dot(way, way);
    return square == 0 ? 0 : std::clamp(dot(spot - a, way) / square, 0.0, 1.0);
}

}

Vec2 in_pixels(Point point)
{
    return {static_cast<double>(point.x.raw()) / Fixed::one, static_cast<double>(point.y.raw()) / Fixed::one};
}

BackboneCell::BackboneCell(const BackboneNode& a, const BackboneNode& b, Point BackboneNode::*side,
                           double first, double last)
    : corner_{in_pixels(a.middle)},
      along_{in_pixels(b.middle) - corner_},
      across_{in_pixels(a.*side) - corner_},
      twist_{in_pixels(b.*side) - in_pixels(b.middle) - across_},
      low_{corner_},
      high_{corner_},
      first_{first},
      last_{last}
{
    for (const Point point : {b.middle, a.*side, b.*side}) {
        const Vec2 spot = in_pixels(point);
        low_ = {std::min(low_.x, spot.x), std::min(low_.y, spot.y)};
        high_ = {std::max(high_.x, spot.x), std::max(high_.y, spot.y)};
    }
}

Vec2 BackboneCell::spot_at(CellPlace place) const
{
    return corner_ + place.along * along_ + place.across * (across_ + place.along * twist_);
}

// With h from the corner to the spot, h - w across is along (along + w twist): their cross product is 0.
std::optional<CellPlace> BackboneCell::place_of(Vec2 spot) const
{
    const Vec2 h = spot - corner_;
    const Roots widths =
        roots_of(-cross(across_, twist_), cross(h, twist_) - cross(across_, along_), cross(h, along_));
    std::optional<CellPlace> best;
    for (std::size_t i = 0; i < widths.count; ++i) {
        const auto place = place_at(h, widths.roots[i]);
        const bool is_better =
            place && (!best || (is_inside(*place) && !is_inside(*best)) ||
                      (is_inside(*place) == is_inside(*best) && place->across < best->across));
        if (is_better)
            best = place;
    }
    return best;
}

std::optional<CellPlace> BackboneCell::place_at(Vec2 from_corner, double across) const
{
    if (across < -noise || across > widest)
        return std::nullopt;
    const double width = std::max(across, 0.0);
    const Vec2 way = along_ + width * twist_;
    const double square = dot(way, way);
    if (square == 0)
        return std::nullopt;
    const double share = dot(from_corner - width * across_, way) / square;
    if (share < first_ - noise || share > last_ + noise)
        return std::nullopt;
    const CellPlace place{std::clamp(share, first_, last_), width};
    const Vec2 error = spot_at(place) - corner_ - from_corner;
    constexpr double largest_error = 1.0 / 256; // px: below what is stored
    if (dot(error, error) > largest_error * largest_error)
        return std::nullopt;
    return place;
}

CellPlace BackboneCell::nearest(Vec2 spot) const
{
    if (const auto place = place_of(spot); place && is_inside(*place))
        return *place;
    CellPlace best;
    double min = -1;
    const auto consider = [&](CellPlace place) {
        const Vec2 way = spot_at(place) - spot;
        if (const double square = dot(way, way); min < 0 || square < min) {
            min = square;
            best = place;
        }
    };
    for (const double across : {0.0, 1.0})
        consider({nearest_share(spot_at({0, across}), spot_at({1, across}), spot), across});
    for (const double along : {0.0, 1.0})
        consider({along, nearest_share(spot_at({along, 0}), spot_at({along, 1}), spot)});
    return best;
}

bool BackboneCell::may_contain(Vec2 spot) const
{
    constexpr double margin = 1.0 / 64;
    return spot.x >= low_.x - margin && spot.x <= high_.x + margin && spot.y >= low_.y - margin &&
           spot.y <= high_.y + margin;
}

bool is_inside(CellPlace place)
{
    return place.along >= -noise && place.along <= 1 + noise && place.across <= 1 + noise;
}

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
    while (nodes[last + 1].backbone >= 0) // a gap follows each backbone
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
