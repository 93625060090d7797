"""Whether two pictures, drawn by different renderers, show the same:

    compare_pictures.py ONE.png OTHER.png [BACKGROUND]

Renderers differ at edges, by a few levels each way. A shape that is missing, moved by a pixel, or of another colour differs
on an area. Both are taken to RGB565, as a panel has it; what is transparent shows BACKGROUND, usually black."""

import dataclasses
import functools
import pathlib
import sys

from PIL import Image, ImageChops, ImageFilter, ImageStat

MOST = (31, 63, 31)

# Pixels on each side: a straight edge that is a pixel off then differs by a fifth of its contrast.
AREA = 2


def on_panel(picture):
    def widened(value, most):
        return ((value * most + 127) // 255 * 255 + most // 2) // most
    return picture.point([widened(value, most) for most in MOST for value in range(256)])


def shown(picture, background):
    if isinstance(picture, (str, pathlib.Path)):
        with Image.open(picture) as file:
            return shown(file.copy(), background)
    below = Image.new("RGBA", picture.size, background)
    return on_panel(Image.alpha_composite(below, picture.convert("RGBA")).convert("RGB"))


def distance(one, other):
    """Of each pixel, that of the channel that differs most."""
    return functools.reduce(ImageChops.lighter, ImageChops.difference(one, other).split())


@dataclasses.dataclass
class Difference:
    """In levels of 0 to 255."""
    near: float  # share of the pixels that are within NEAR
    worst: int   # of the mean colour of an area of 5 x 5 pixels
    at: tuple    # the middle of that area
    mean: float  # of the mean colour of the pictures, in the channel where it is largest

    NEAR = 32

    def problems(self, near=0.99, worst=16, mean=2):
        """What is wrong, as a list of sentences; the limits are for shapes with a contrast of at least 100."""
        found = []
        if self.near < near:
            found.append(f"only {self.near:.2%} of the pixels are near, and not {near:.2%}")
        if self.worst > worst:
            found.append(f"the area around {self.at} is {self.worst} levels away, and not at most {worst}")
        if self.mean > mean:
            found.append(f"the mean colour is {self.mean:.1f} levels away, and not at most {mean}")
        return found

    def __str__(self):
        return f"{self.near:.2%} near, worst area {self.worst} at {self.at}, mean {self.mean:.2f}"


def brightest(picture):
    """The highest level, and the first pixel that has it."""
    level = picture.getextrema()[1]
    left, top, *_ = picture.point(lambda value: 255 * (value == level)).getbbox() or (0, 0)
    row = picture.crop((0, top, picture.width, top + 1)).point(lambda value: 255 * (value == level)).getbbox()
    return level, (row[0] if row else left, top)


def compare(one, other, background="black"):
    """Of two pictures, or files of such. Raises ValueError if they are not of one size."""
    one, other = shown(one, background), shown(other, background)
    if one.size != other.size:
        raise ValueError(f"one is {one.width} x {one.height}, the other {other.width} x {other.height}")
    levels = distance(one, other).histogram()
    blur = ImageFilter.BoxBlur(AREA)
    worst, at = brightest(distance(one.filter(blur), other.filter(blur)))
    means = zip(ImageStat.Stat(one).mean, ImageStat.Stat(other).mean)
    return Difference(near=sum(levels[:Difference.NEAR + 1]) / (one.width * one.height), worst=worst, at=at,
                      mean=max(abs(a - b) for a, b in means))


def main(*arguments):
    difference = compare(*arguments)
    print(difference, *difference.problems(), sep="\n")
    return 1 if difference.problems() else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
