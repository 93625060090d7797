"""Draws by the definition: the coverage of a pixel is the area of it that lies inside the outline."""

import itertools
import math

from PIL import Image


def coverage(polygon, size):
    """Of each pixel in 0 ... 255, rounded once. `polygon` lies inside the picture and does not cross itself."""
    steps = no_steps(size)
    for start, end in zip(polygon, polygon[1:] + polygon[:1]):
        add_edge(steps, start, end)
    return summed_up(steps, size)


def no_steps(size):
    """For each pixel, by how much more than its left neighbour it is covered: nothing yet."""
    width, height = size
    return [[0.0] * (width + 1) for _ in range(height)]


def summed_up(steps, size):
    width, _ = size
    pixels = bytearray()
    for row in steps:
        pixels.extend(levels(row[:-1]) if any(row) else bytes(width))
    return Image.frombytes("L", size, bytes(pixels))


def levels(row):
    return (round(255 * min(1, abs(area))) for area in itertools.accumulate(row))


def add_edge(steps, start, end):
    """Covers what lies to the right of the edge, or uncovers it if the edge goes up."""
    (x0, y0), (x1, y1) = start, end
    if y0 == y1:
        return
    cuts = sorted({0.0, 1.0, *grid_crossings(x0, x1), *grid_crossings(y0, y1)})
    for a, b in itertools.pairwise(cuts):
        middle = (a + b) / 2
        x, y = x0 + (x1 - x0) * middle, y0 + (y1 - y0) * middle
        cover_right_of(x, (b - a) * (y1 - y0), steps[math.floor(y)])


def cover_right_of(x, tall, row):
    """`tall` of the pixels' height, from the mean `x` of what lies in one pixel."""
    column = math.floor(x)
    row[column] += tall * (column + 1 - x)
    row[column + 1] += tall * (x - column)


def grid_crossings(a, b):
    low, high = min(a, b), max(a, b)
    return [(line - a) / (b - a) for line in range(math.ceil(low), math.floor(high) + 1)] if low < high else []
