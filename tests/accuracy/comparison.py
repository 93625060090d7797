"""How far two pictures are apart, as a panel of RGB565 shows them."""

import functools

from PIL import Image, ImageChops, ImageColor

MOST = (31, 63, 31)


def level(channel, most):
    return (channel * most + 127) // 255


def widened(value, most):
    return (value * 255 + most // 2) // most


def on_panel(picture):
    """Each channel as RGB565 has it, widened again to 8 bits."""
    return picture.convert("RGB").point([widened(level(c, most), most) for most in MOST for c in range(256)])


def painted(background, layers, size):
    """Each of `layers`, a coverage and a colour, over those before it, blended in RGB565 and widened again."""
    channels = [Image.new("L", size, step) for step in steps(background)]
    for covered, colour in layers:
        channels = [Image.composite(Image.new("L", size, step), channel, covered)
                    for step, channel in zip(steps(colour), channels)]
    return Image.merge("RGB", [channel.point([widened(min(value, most), most) for value in range(256)])
                               for channel, most in zip(channels, MOST)])


def steps(colour):
    return [level(channel, most) for channel, most in zip(ImageColor.getrgb(colour), MOST)]


def distance(one, other):
    """Of each pixel, that of the channel that differs most."""
    return functools.reduce(ImageChops.lighter, ImageChops.difference(one, other).split())


def plain(picture, colours):
    """255 where a pixel has one of the colours."""
    places = [distance(picture, on_panel(Image.new("RGB", picture.size, colour))).point(lambda far: 255 * (far == 0))
              for colour in colours]
    return functools.reduce(ImageChops.lighter, places)


class Comparison:
    """Adds up over pictures. Edges are the pixels that are not plain in both."""

    CLOSE = 16

    def __init__(self, colours):
        self._colours = colours
        self._edges = [0] * 256
        self._pixels = 0
        self.wrong_plain = 0

    def add(self, one, other):
        far = distance(one, other)
        both_plain = ImageChops.darker(plain(one, self._colours), plain(other, self._colours))
        edges = far.histogram(ImageChops.invert(both_plain))
        self._edges = [a + b for a, b in zip(self._edges, edges)]
        self._pixels += one.width * one.height
        self.wrong_plain += sum(far.histogram(both_plain)[1:])

    @property
    def edge_share(self):
        """Of all pixels, 0 to 1."""
        return sum(self._edges) / max(1, self._pixels)

    @property
    def close(self):
        """Share of the edges, 0 to 1."""
        return sum(self._edges[:self.CLOSE + 1]) / max(1, sum(self._edges))

    @property
    def farthest(self):
        return max((far for far, count in enumerate(self._edges) if count), default=0)

    def __str__(self):
        return (f"{self.close:7.2%} of {sum(self._edges)} edge pixels within {self.CLOSE}, farthest {self.farthest}, "
                f"wrong plain pixels {self.wrong_plain}")
