#include "host/art/geometry/cubic_fit.hpp"

namespace kfast::art {

using scene::Vec2;

void CubicFit::take(double parameter, Vec2 spot, double weight)
{
    const double rest = 1 - parameter;
    const double at_first = 3 * rest * rest * parameter; // the weights of the two control points
    const double at_last = 3 * rest * parameter * parameter;
    const double begin = rest * rest * rest + at_first;
    const Vec2 miss = spot - (begin * from_ + (1 - begin) * to_);
    first_ += weight * at_first * at_first;
    both_ += weight * at_first * at_last;
    last_ += weight * at_last * at_last;
    towards_first_ = towards_first_ + weight * at_first * miss;
    towards_last_ = towards_last_ + weight * at_last * miss;
}

CubicPiece CubicFit::free() const
{
    const double determinant = first_ * last_ - both_ * both_;
    const Vec2 first = 1 / determinant * (last_ * towards_first_ - both_ * towards_last_);
    const Vec2 last = 1 / determinant * (first_ * towards_last_ - both_ * towards_first_);
    return {{from_, from_ + first, to_ + last, to_}};
}

CubicPiece CubicFit::along(Vec2 first, Vec2 last) const
{
    first = 1 / distance({}, first) * first;
    last = -1 / distance({}, last) * last;
    const double both = both_ * dot(first, last);
    const double determinant = first_ * last_ - both * both;
    const double towards_first = dot(towards_first_, first);
    const double towards_last = dot(towards_last_, last);
    return {{from_, from_ + (last_ * towards_first - both * towards_last) / determinant * first,
             to_ + (first_ * towards_last - both * towards_first) / determinant * last, to_}};
}

}
