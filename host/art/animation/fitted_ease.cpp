#include "host/art/animation/fitted_ease.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace kfast::art {
namespace {

using Vector = std::array<double, 4>; ///< x1, y1, x2, y2
using Matrix = std::array<Vector, 4>;

Ease ease_of(const Vector& at) { return {EaseKind::cubic, at[0], at[1], at[2], at[3]}; }

Vector bounded(Vector at)
{
    for (const std::size_t x : {std::size_t{0}, std::size_t{2}})
        at[x] = std::clamp(at[x], 0.0, 1.0);
    for (const std::size_t y : {std::size_t{1}, std::size_t{3}})
        at[y] = std::clamp(at[y], -2.0, 3.0);
    return at;
}

/// Gaussian elimination with pivots; the matrix is damped, and so never singular.
Vector solved(Matrix left, Vector right)
{
    for (std::size_t column = 0; column < 4; ++column) {
        std::size_t pivot = column;
        for (std::size_t row = column + 1; row < 4; ++row)
            if (std::abs(left[row][column]) > std::abs(left[pivot][column]))
                pivot = row;
        std::swap(left[column], left[pivot]);
        std::swap(right[column], right[pivot]);
        for (std::size_t row = column + 1; row < 4; ++row) {
            const double factor = left[row][column] / left[column][column];
            for (std::size_t i = column; i < 4; ++i)
                left[row][i] -= factor * left[column][i];
            right[row] -= factor * right[column];
        }
    }
    for (std::size_t row = 4; row-- > 0;) {
        for (std::size_t i = row + 1; i < 4; ++i)
            right[row] -= left[row][i] * right[i];
        right[row] /= left[row][row];
    }
    return right;
}

/// How far a cubic ease misses given progress values.
class Misses {
public:
    Misses(std::span<const double> ways, const Vector& at)
    {
        const Ease ease = ease_of(at);
        for (std::size_t i = 1; i + 1 < ways.size(); ++i)
            add(ways[i], at,
                parameter_at(ease, static_cast<double>(i) / static_cast<double>(ways.size() - 1)));
    }

    double sum() const { return sum_; }

    /// The Levenberg-Marquardt step.
    Vector step(double damping) const
    {
        Matrix damped = squares_;
        for (std::size_t i = 0; i < 4; ++i)
            damped[i][i] += damping * (squares_[i][i] + 1e-6);
        return solved(damped, towards_);
    }

private:
    void add(double way, const Vector& at, double s)
    {
        const double rest = 1 - s;
        const double b1 = 3 * rest * rest * s;
        const double b2 = 3 * rest * s * s;
        const auto slope = [&](double first, double second) {
            return 3 * (rest * rest * first + 2 * rest * s * (second - first) + s * s * (1 - second));
        };
        const double miss = way - (b1 * at[1] + b2 * at[3] + s * s * s);
        const double steepness = slope(at[1], at[3]) / std::max(slope(at[0], at[2]), 1e-3);
        const Vector change{-steepness * b1, b1, -steepness * b2, b2};
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < 4; ++j)
                squares_[i][j] += change[i] * change[j];
            towards_[i] += change[i] * miss;
        }
        sum_ += miss * miss;
    }

    double sum_ = 0;
    Matrix squares_{};
    Vector towards_{};
};

Vector first_guess(std::span<const double> ways)
{
    const auto steps = static_cast<double>(ways.size() - 1);
    const double first_slope = (ways[1] - ways[0]) * steps;
    const double last_slope = (ways[ways.size() - 1] - ways[ways.size() - 2]) * steps;
    return bounded({1.0 / 3, first_slope / 3, 2.0 / 3, 1 - last_slope / 3});
}

double rounded(double value) { return std::round(value * 8192) / 8192; }

}

std::optional<Ease> fitted_ease(std::span<const double> ways)
{
    constexpr int max_rounds = 24;
    if (ways.size() < 5)
        return std::nullopt;
    Vector best = first_guess(ways);
    Misses misses{ways, best};
    double damping = 0.01;
    for (int round = 0; round < max_rounds && misses.sum() > 1e-12; ++round) {
        Vector next = best;
        const Vector step = misses.step(damping);
        for (std::size_t i = 0; i < 4; ++i)
            next[i] += step[i];
        next = bounded(next);
        const Misses missed{ways, next};
        const bool better = missed.sum() < misses.sum();
        damping *= better ? 0.2 : 8;
        if (better) {
            best = next;
            misses = missed;
        } else if (damping > 1e6) {
            break;
        }
    }
    for (double& value : best)
        value = rounded(value);
    return ease_of(best);
}

}
