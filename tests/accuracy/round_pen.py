"""Draws by the definition: the coverage of a pixel is the area of it that a round pen passes over.

In rows of samples, for this area is no polygon, and the pen may cross its own way. Along a row it is exact.
"""

import itertools
import math

from true_area import cover_right_of, no_steps, summed_up

ROWS_OF_PIXEL = 32


def coverage_by_pen(chords, width, size):
    """Of each pixel in 0 ... 255, rounded once. All that the pen passes over lies inside the picture."""
    steps = no_steps(size)
    for row, spans in spans_by_row(chords, width / 2).items():
        pixels = steps[row // ROWS_OF_PIXEL]
        for left, right in united(spans):
            cover_right_of(left, 1 / ROWS_OF_PIXEL, pixels)
            cover_right_of(right, -1 / ROWS_OF_PIXEL, pixels)
    return summed_up(steps, size)


def spans_by_row(chords, radius):
    """From where to where the pen covers a row, at each end of a chord and on its way between two."""
    ends = (span for centre in chords for span in disc_spans(centre, radius))
    ways = (span for chord in itertools.pairwise(chords) for span in band_spans(*chord, radius))
    spans = {}
    for row, left, right in itertools.chain(ends, ways):
        spans.setdefault(row, []).append((left, right))
    return spans


def disc_spans(centre, radius):
    x, y = centre
    for row, down in rows_about(y, -radius, radius):
        reach = math.sqrt(max(0, radius ** 2 - down ** 2))
        yield row, x - reach, x + reach


def band_spans(start, end, radius):
    """Of the rectangle around a chord: a row lies in it where it is neither behind the ends nor beyond the sides."""
    (x, y), (end_x, end_y) = start, end
    length = math.dist(start, end)
    if not length:
        return
    along_x, along_y = (end_x - x) / length, (end_y - y) / length
    for row, down in rows_about(y, min(0, end_y - y) - radius, max(0, end_y - y) + radius):
        after_start, before_end = where_between(0, length, along_x, along_y * down)
        inside_one, inside_other = where_between(-radius, radius, -along_y, along_x * down)
        left, right = max(after_start, inside_one), min(before_end, inside_other)
        if left < right:
            yield row, x + left, x + right


def rows_about(y, top, bottom):
    """The rows whose middles lie between `top` and `bottom`, each with its middle; both measured from `y`."""
    first, last = (math.ceil(ROWS_OF_PIXEL * (y + down) - 0.5) for down in (top, bottom))
    return [(row, (row + 0.5) / ROWS_OF_PIXEL - y) for row in range(first, last)]


def where_between(low, high, slope, offset):
    """The least and the greatest x for which slope x + offset lies between `low` and `high`."""
    if slope > 0:
        return (low - offset) / slope, (high - offset) / slope
    if slope < 0:
        return (high - offset) / slope, (low - offset) / slope
    return (-math.inf, math.inf) if low <= offset <= high else (math.inf, -math.inf)


def united(spans):
    """Spans that do not meet, for spans that may."""
    spans = sorted(spans)
    left, right = spans[0]
    for next_left, next_right in spans:
        if next_left > right:
            yield left, right
            left, right = next_left, next_right
        right = max(right, next_right)
    yield left, right
