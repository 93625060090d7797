#include "core/beam/beam_route.hpp"

#include "core/beam/beam_profile.hpp"
#include "core/beam/nearest_neighbour.hpp"
#include "core/beam/tour.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace kfast {

namespace {

/// 2^bits is the power of two nearest to the square root of a third of the number of lines, at most 2^7.
int strip_bits_for(std::size_t lines)
{
    int bits = 0;
    while (bits < 7 && (std::size_t{3} << 2 * (bits + 1)) <= 2 * lines)
        ++bits;
    return bits;
}

/// The number of the strip, and after it the position in the strip.
std::uint16_t place_in_strips(FieldPoint at, int strip_bits)
{
    const int place_bits = 16 - strip_bits;
    const auto strip = static_cast<std::uint32_t>(at.y - field_min) >> place_bits;
    const auto across = static_cast<std::uint32_t>(at.x - field_min) >> strip_bits;
    const std::uint32_t mask = (1U << place_bits) - 1;
    return static_cast<std::uint16_t>(strip << place_bits | (strip % 2 == 0 ? across : mask - across));
}

}

void order_by_strips(const BeamLines& lines, std::span<BeamLeg> legs)
{
    const int strip_bits = strip_bits_for(legs.size());
    for (std::size_t number = 0; number < legs.size(); ++number) {
        const FieldPoint at = lines.points(lines.line(number)).front();
        legs[number] = {static_cast<std::uint16_t>(number), place_in_strips(at, strip_bits)};
    }
    const auto is_before = [](const BeamLeg& a, const BeamLeg& b) {
        return a.start != b.start ? a.start < b.start : a.line < b.line;
    };
    std::make_heap(legs.begin(), legs.end(), is_before);
    std::sort_heap(legs.begin(), legs.end(), is_before);
    for (BeamLeg& leg : legs)
        leg.start = 0;
}

namespace {

/// The maximum number of lines that are all compared with each other.
constexpr std::size_t max_compared = 128;

/// The fraction of the effort for further attempts after the first, which gain little.
constexpr std::uint32_t more_attempts_share = 4;

/// In legs along the tour.
constexpr std::size_t near = 16;

/// Tries to find a route from several beginnings. There is room for one route only: how the best one was
/// found is kept, and it is found once more if it was not the last.
class RouteSearch {
public:
    RouteSearch(const BeamLines& lines, FieldPoint from, std::span<BeamLeg> legs)
        : lines_{lines}, from_{from}, legs_{legs}
    {
    }

    /// Returns how much of the effort was spent.
    std::uint32_t run(std::uint32_t effort);

private:
    struct Attempt {
        std::size_t number = 0;
        std::uint32_t allowed = 0; ///< effort
        std::uint32_t spent = 0;
        std::uint64_t travel = std::numeric_limits<std::uint64_t>::max();
    };

    Attempt attempt(std::size_t number, std::uint32_t allowed);
    std::size_t attempts() const { return legs_.size() <= max_compared ? 2 * legs_.size() + 1 : 1; }
    void begin(std::size_t number, RouteEffort& effort);
    void begin_with_shortest(std::uint32_t effort);
    void order_by_lines(FieldPoint from, std::uint32_t effort);
    void keep_order();
    std::size_t window(std::uint32_t effort) const;

    const BeamLines& lines_;
    FieldPoint from_;
    std::span<BeamLeg> legs_;
};

std::uint32_t RouteSearch::run(std::uint32_t effort)
{
    Attempt best = attempt(0, effort);
    std::uint32_t spent = best.spent;
    std::uint32_t left = std::min(effort - best.spent, effort / more_attempts_share);
    bool is_found = true;
    for (std::size_t number = 1; number < attempts() && left > best.spent && best.travel != 0; ++number) {
        const Attempt other = attempt(number, left - best.spent);
        left -= other.spent;
        spent += other.spent;
        is_found = other.travel < best.travel;
        if (is_found)
            best = other;
    }
    if (!is_found)
        spent += attempt(best.number, best.allowed).spent;
    return spent;
}

RouteSearch::Attempt RouteSearch::attempt(std::size_t number, std::uint32_t allowed)
{
    RouteEffort effort{allowed};
    begin(number, effort);
    Tour tour{lines_, legs_};
    const std::size_t widest = window(allowed);
    for (std::size_t width = near; width < widest; width *= 4) // most of what helps is near
        improve(tour, width, effort);
    improve(tour, widest, effort);
    return {number, allowed, allowed - effort.left(), travel_of(lines_, legs_)};
}

void RouteSearch::begin(std::size_t number, RouteEffort& effort)
{
    if (number == 0)
        return begin_with_shortest(effort.left());
    const auto points = lines_.points(lines_.line((number - 1) / 2));
    order_by_lines(number % 2 == 0 ? points.back() : points.front(), effort.left());
    effort.spend(static_cast<std::uint32_t>(legs_.size() * legs_.size() / 2));
}

/// As drawn, item by item, or line by line.
void RouteSearch::begin_with_shortest(std::uint32_t effort)
{
    keep_order();
    const std::uint64_t as_drawn = travel_of(lines_, legs_);
    const bool has_items = follow_nearest_items(lines_, from_, max_compared, legs_);
    const std::uint64_t by_items = has_items ? travel_of(lines_, legs_) : as_drawn;
    order_by_lines(from_, effort);
    if (travel_of(lines_, legs_) < std::min(as_drawn, by_items))
        return;
    if (by_items < as_drawn)
        follow_nearest_items(lines_, from_, max_compared, legs_);
    else
        keep_order();
}

void RouteSearch::order_by_lines(FieldPoint from, std::uint32_t effort)
{
    const bool is_few = legs_.size() <= max_compared;
    if (is_few)
        keep_order();
    else
        order_by_strips(lines_, legs_);
    follow_nearest_lines(lines_, from, is_few ? legs_.size() : window(effort), legs_);
}

void RouteSearch::keep_order()
{
    for (std::size_t number = 0; number < legs_.size(); ++number)
        legs_[number] = {.line = static_cast<std::uint16_t>(number)};
}

/// How many legs each one may be compared with, if all of them together may cost the effort.
std::size_t RouteSearch::window(std::uint32_t effort) const
{
    return std::clamp<std::size_t>(effort / legs_.size() / 2, 1, legs_.size());
}

std::size_t nearest_to(FieldPoint from, const Tour& tour)
{
    std::size_t nearest = 0;
    for (std::size_t place = 1; place < tour.size(); ++place)
        if (beam_travel(from, tour.begin_of(place)) < beam_travel(from, tour.begin_of(nearest)))
            nearest = place;
    return nearest;
}

}

std::uint32_t find_route(const BeamLines& lines, FieldPoint from, std::span<BeamLeg> legs,
                         std::uint32_t effort)
{
    if (legs.empty())
        return 0;
    const std::uint32_t spent = RouteSearch{lines, from, legs}.run(effort);
    Tour tour{lines, legs};
    tour.begin_at(nearest_to(from, tour));
    return spent;
}

std::uint64_t travel_of(const BeamLines& lines, std::span<const BeamLeg> legs)
{
    std::uint64_t travel = 0;
    for (std::size_t i = 0; i < legs.size(); ++i)
        travel += static_cast<std::uint64_t>(
            beam_travel(end_of(lines, legs[i == 0 ? legs.size() - 1 : i - 1]), begin_of(lines, legs[i])));
    return travel;
}

}
