"""Costs that explain measured sums best, none of them negative."""

import numpy


def solve(gram, target, free):
    """The least squares if all others are 0."""
    x = numpy.zeros(len(target))
    x[free] = numpy.linalg.lstsq(gram[numpy.ix_(free, free)], target[free], rcond=None)[0]
    return x


def nonnegative(matrix, wanted):
    """x >= 0 with the least |matrix x - wanted|^2, by the active set method of Lawson and Hanson."""
    gram, target = matrix.T @ matrix, matrix.T @ wanted
    x = numpy.zeros(matrix.shape[1])
    free = numpy.zeros(matrix.shape[1], bool)
    for _ in range(10 * len(x)):
        gain = numpy.where(free, 0, target - gram @ x)
        if gain.max() <= 1e-9 * numpy.abs(target).max():
            break
        free[gain.argmax()] = True
        while (trial := solve(gram, target, free))[free].min() <= 0:
            falling = free & (trial <= 0)
            x += (x[falling] / (x[falling] - trial[falling])).min() * (trial - x)
            free &= x > 1e-12
        x = trial
    return x


def fitted(matrix, wanted):
    """As nonnegative(), of relative errors."""
    scale = numpy.abs(matrix).max(axis=0)
    scale[scale == 0] = 1
    return nonnegative(matrix / scale / wanted[:, None], numpy.ones_like(wanted)) / scale
