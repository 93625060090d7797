"""Draws by the definition: the coverage of a pixel is the area of it that lies inside the outline."""

import itertools
import math

from PIL import Image


def coverage(polygon, size):
    """Of each pixel in 0 ... 255, rounded once. `polygon` lies inside the picture and does not cross itself."""
    width, height = size
    steps = [[0.0] * (width + 1) for _ in range(height)]
    for start, end in zip(polygon, polygon[1:] + polygon[:1]):
        add_edge(steps, start, end)
    pixels = bytearray()
    for row in steps:
        pixels.extend(round(255 * min(1, abs(area))) for area in itertools.islice(itertools.accumulate(row), width))
    return Image.frombytes("L", size, bytes(pixels))


def add_edge(steps, start, end):
    """Adds to each pixel by how much more than its left neighbour the edge covers of it."""
    (x0, y0), (x1, y1) = start, end
    if y0 == y1:
        return
    cuts = sorted({0.0, 1.0, *grid_crossings(x0, x1), *grid_crossings(y0, y1)})
    for a, b in itertools.pairwise(cuts):
        middle = (a + b) / 2
        x, y = x0 + (x1 - x0) * middle, y0 + (y1 - y0) * middle
        column, row = math.floor(x), math.floor(y)
        tall = (b - a) * (y1 - y0)
        steps[row][column] += tall * (column + 1 - x)
        steps[row][column + 1] += tall * (x - column)


def grid_crossings(a, b):
    low, high = min(a, b), max(a, b)
    return [(line - a) / (b - a) for line in range(math.ceil(low), math.floor(high) + 1)] if low < high else []


def true_polygon(outline, pieces=32):
    """So many chords for each cubic that they lie on it for all that can be seen."""
    return [point_at(curve, piece / pieces) for curve in outline for piece in range(pieces)]


def coarse_polygon(outline, tolerance):
    """Chords of halved cubics whose control points stay within `tolerance` of the chord and between its ends."""
    return [start for curve in outline for start in chord_starts(curve, tolerance)]


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


def point_at(curve, t):
    weights = ((1 - t) ** 3, 3 * (1 - t) ** 2 * t, 3 * (1 - t) * t ** 2, t ** 3)
    return tuple(sum(weight * point[axis] for weight, point in zip(weights, curve)) for axis in (0, 1))
