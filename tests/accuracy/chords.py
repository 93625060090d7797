"""Cubics as chords, which are halved until they are flat."""

import math


def chords(outline, tolerance):
    """All their ends. The control points of a chord's piece lie within `tolerance` of it and between its ends."""
    starts = [start for curve in outline for start in chord_starts(curve, tolerance)]
    return [*starts, outline[-1][-1]]


def chord_starts(curve, tolerance):
    if is_flat(curve, tolerance):
        return [curve[0]]
    return [start for half in halves(curve) for start in chord_starts(half, tolerance)]


def is_flat(curve, tolerance):
    (x0, y0), *controls, (x3, y3) = curve
    along_x, along_y = x3 - x0, y3 - y0
    length = math.hypot(along_x, along_y)
    for x, y in controls:
        if abs(along_x * (y - y0) - along_y * (x - x0)) > tolerance * length:
            return False
        if (x - x0) * (x - x3) + (y - y0) * (y - y3) > 0:
            return False
    return True


def halves(curve):
    a, b, c, d = curve
    ab, bc, cd = middle(a, b), middle(b, c), middle(c, d)
    abc, bcd = middle(ab, bc), middle(bc, cd)
    centre = middle(abc, bcd)
    return [a, ab, abc, centre], [centre, bcd, cd, d]


def middle(a, b):
    return (a[0] + b[0]) / 2, (a[1] + b[1]) / 2
