#include "host/scene_text/ease_pieces.hpp"

#include "host/scene_text/grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace kfast::scene_text {
namespace {

using art::Ease;
using art::EaseKind;

bool in_range(const Ease& ease)
{
    const auto [low, high] = std::minmax(ease.y1, ease.y2);
    return ease.kind != EaseKind::cubic || (low >= controls.low && high <= controls.high);
}

/// A Bézier from 0 to 1 by its inner control points, as a polynomial of three blossom arguments.
double blossom(double first, double second, double u, double v, double w)
{
    const double one = u * (1 - v) * (1 - w) + v * (1 - u) * (1 - w) + w * (1 - u) * (1 - v);
    const double two = u * v * (1 - w) + u * w * (1 - v) + v * w * (1 - u);
    return one * first + two * second + u * v * w;
}

/// Where y turns round: parameters between 0 and 1, rising.
std::vector<double> turning_points(const Ease& ease)
{
    // dy/ds is 3 (a s² + b s + c).
    const double a = 3 * ease.y1 - 3 * ease.y2 + 1;
    const double b = 2 * (ease.y2 - 2 * ease.y1);
    const double c = ease.y1;
    const double discriminant = b * b - 4 * a * c;
    if (discriminant <= 0)
        return {};
    const double sum = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
    std::vector<double> turns;
    if (a != 0)
        turns.push_back(sum / a);
    if (sum != 0)
        turns.push_back(c / sum);
    std::erase_if(turns, [](double turn) { return !(turn > 1e-6 && turn < 1 - 1e-6); });
    std::ranges::sort(turns);
    return turns;
}

/// Between two parameters, as an ease of its own.
EasePiece piece(const Ease& ease, double from, double to)
{
    const auto x = [&](double u, double v, double w) { return blossom(ease.x1, ease.x2, u, v, w); };
    const auto y = [&](double u, double v, double w) { return blossom(ease.y1, ease.y2, u, v, w); };
    const double time = x(from, from, from);
    const double way = y(from, from, from);
    const double duration = x(to, to, to) - time;
    const double length = y(to, to, to) - way;
    const auto share_of_time = [&](double at) {
        return duration > 0 ? std::clamp((at - time) / duration, 0.0, 1.0) : 0.5;
    };
    const auto share_of_way = [&](double at) {
        return length != 0 ? std::clamp((at - way) / length, controls.low, controls.high) : 0;
    };
    return {time,
            way,
            {EaseKind::cubic, share_of_time(x(from, from, to)), share_of_way(y(from, from, to)),
             share_of_time(x(from, to, to)), share_of_way(y(from, to, to))}};
}

struct NamedLaw {
    std::string_view name;
    std::array<double, 4> controls;
};

constexpr std::array<NamedLaw, 4> named_laws{{{"ease", {0.25, 0.1, 0.25, 1}},
                                              {"ease-in", {0.42, 0, 1, 1}},
                                              {"ease-out", {0, 0, 0.58, 1}},
                                              {"ease-in-out", {0.42, 0, 0.58, 1}}}};

using StoredControls = std::array<std::int32_t, 4>;

StoredControls stored(const std::array<double, 4>& numbers)
{
    StoredControls result{};
    std::ranges::transform(numbers, result.begin(), [](double number) { return on_grid(number, controls); });
    return result;
}

std::string law_of(const StoredControls& numbers)
{
    for (const NamedLaw& law : named_laws)
        if (stored(law.controls) == numbers)
            return std::string{law.name};
    std::string text = "bezier(";
    for (const std::int32_t& control : numbers)
        text += decimal(control, controls) + (&control == &numbers.back() ? ')' : ',');
    return text;
}

}

std::vector<EasePiece> ease_pieces(const Ease& ease)
{
    if (in_range(ease))
        return {{0, 0, ease}};
    std::vector<double> ends = turning_points(ease);
    ends.insert(ends.begin(), 0);
    ends.push_back(1);
    std::vector<EasePiece> pieces;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        pieces.push_back(piece(ease, ends[i], ends[i + 1]));
    return pieces;
}

std::string law_of(const Ease& ease)
{
    if (ease.kind == EaseKind::hold)
        return "hold";
    if (ease.kind == EaseKind::linear)
        return "constant";
    const StoredControls numbers =
        stored({std::clamp(ease.x1, 0.0, 1.0), ease.y1, std::clamp(ease.x2, 0.0, 1.0), ease.y2});
    if (numbers[0] == numbers[1] && numbers[2] == numbers[3])
        return "constant";
    return law_of(numbers);
}

}
