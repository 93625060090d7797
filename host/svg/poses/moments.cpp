#include "host/svg/poses/moments.hpp"

#include "host/svg/parts/motion.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace kfast::svg {

namespace {

using art::Affine;

bool is_there(const Moment& moment) { return moment.part != nullptr; }

bool nearly_equal(double left, double right) { return std::abs(left - right) <= 1e-5; }

/// The first moment, or the largest one where the first is much smaller: points are rounded before scaling.
std::size_t moment_of_rest(const std::vector<Affine>& all)
{
    constexpr double much = 4; // by area
    const auto largest =
        std::ranges::max_element(all, {}, [](const Affine& each) { return std::abs(each.determinant()); });
    const bool first_will_do = std::abs(all.front().determinant()) * much >= std::abs(largest->determinant());
    return first_will_do ? 0 : static_cast<std::size_t>(largest - all.begin());
}

double shortest_from(double last, double degrees)
{
    return degrees + 360 * std::round((last - degrees) / 360);
}

}

const Part& first_part(const Moments& moments) { return *std::ranges::find_if(moments, is_there)->part; }

Moments present(const Moments& moments)
{
    Moments result;
    std::ranges::copy_if(moments, std::back_inserter(result), is_there);
    return result;
}

std::vector<Instant> instants(const Moments& moments)
{
    std::vector<Instant> result;
    for (const Moment& moment : moments)
        result.push_back(moment.instant);
    return result;
}

std::vector<art::Span> spans(const Moments& moments)
{
    std::vector<art::Span> result;
    for (std::size_t i = 0; i < moments.size(); ++i) {
        if (!is_there(moments[i]) || (i > 0 && is_there(moments[i - 1])))
            continue;
        art::Span span;
        if (i > 0)
            span.from = moments[i].instant.time;
        const auto end =
            std::find_if_not(moments.begin() + static_cast<std::ptrdiff_t>(i), moments.end(), is_there);
        if (end != moments.end())
            span.to = end->instant.time;
        result.push_back(span);
    }
    return result;
}

std::vector<Affine> ways(const Moments& moments)
{
    std::vector<Affine> result;
    for (const Moment& moment : moments)
        result.push_back(is_there(moment) ? moment.fold * moment.part->own : moment.fold);
    return result;
}

std::optional<Motion> motion_of(const Moments& moments)
{
    const Moments seen = present(moments);
    const auto all = ways(seen);
    const std::size_t rest = moment_of_rest(all);
    const auto back = all[rest].inverse();
    const auto box = box_of(*seen[rest].part, all[rest]);
    if (!back || !box)
        return std::nullopt;
    std::vector<Affine> from_there;
    from_there.reserve(all.size());
    for (const Affine& way : all)
        from_there.push_back(way * *back);
    return motion_of(all[rest], std::move(from_there), *box);
}

std::optional<Motion> motion_of(const Affine& at_rest, std::vector<Affine> from_there, const Box& box)
{
    const bool stays =
        std::ranges::all_of(from_there, [](const Affine& each) { return is_near(each, Affine{}); });
    if (stays ||
        !std::ranges::all_of(from_there, [](const Affine& each) { return move_of(each).has_value(); }))
        return std::nullopt;
    const scene::Vec2 pivot = pivot_of(from_there, box);
    return Motion{at_rest, std::move(from_there), pivot};
}

art::Transform transform_of(const Motion& motion, const Moments& moments, art::Budget& budget)
{
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> rotate;
    std::vector<double> scale_x;
    std::vector<double> scale_y;
    for (const Affine& affine : motion.from_there) {
        const Move move = *move_of(affine);
        const scene::Vec2 to = affine.of(motion.pivot);
        x.push_back(to.x);
        y.push_back(to.y);
        rotate.push_back(rotate.empty() ? move.rotate : shortest_from(rotate.back(), move.rotate));
        scale_x.push_back(move.scale_x);
        scale_y.push_back(move.scale_y);
    }
    const auto when = instants(moments);
    const auto channel = [&](const std::vector<double>& values) {
        return keyed(when, values, nearly_equal, budget);
    };
    art::Transform transform;
    transform.anchor_x = {motion.pivot.x};
    transform.anchor_y = {motion.pivot.y};
    transform.x = channel(x);
    transform.y = channel(y);
    transform.rotate = channel(rotate);
    transform.scale_x = channel(scale_x);
    transform.scale_y = channel(scale_y);
    return transform;
}

}
