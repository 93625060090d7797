#pragma once

#include "tests/core/spot.hpp"

#include <array>
#include <cmath>

namespace kfast::test {

/// Of a row vector (x, y, 1).
using Matrix = std::array<std::array<double, 3>, 3>;

inline Matrix operator*(const Matrix& a, const Matrix& b)
{
    Matrix product{};
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
            for (std::size_t i = 0; i < 3; ++i)
                product[row][column] += a[row][i] * b[i][column];
    return product;
}

inline Spot operator*(Spot p, const Matrix& m)
{
    return {p.x * m[0][0] + p.y * m[1][0] + m[2][0], p.x * m[0][1] + p.y * m[1][1] + m[2][1]};
}

inline Matrix moved(Spot by) { return {{{1, 0, 0}, {0, 1, 0}, {by.x, by.y, 1}}}; }

/// Clockwise on the screen.
inline Matrix turned(double radians)
{
    const double c = std::cos(radians);
    const double s = std::sin(radians);
    return {{{c, s, 0}, {-s, c, 0}, {0, 0, 1}}};
}

inline Matrix stretched(double along) { return {{{along, 0, 0}, {0, 1, 0}, {0, 0, 1}}}; }

}
