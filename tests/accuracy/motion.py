"""What moves in a scene, as numbers: see README.md for the files. Points are (x, y) in pixels."""

import cmath
import json
import math
from dataclasses import dataclass


@dataclass
class Layer:
    """What is painted at once: all that lies inside an outline, or a round pen's line along it."""

    outline: list
    colour: str
    width: float | None = None


class Motion:
    def __init__(self, file):
        scene = json.loads(file.read_text(encoding="utf-8"))
        self.background = scene["background"]
        self._law = scene["law"]
        self._objects = scene["objects"]
        self._by_name = {thing["name"]: thing for thing in self._objects if "name" in thing}
        self._drawings = scene["drawings"]

    @property
    def colours(self):
        used = [thing[layer] for thing in self._objects for layer in ("fill", "stroke") if layer in thing]
        return list(dict.fromkeys([self.background, *used]))

    def layers(self, frame):
        """The lowest first. Outlines are lists of cubics of four points."""
        for thing in self._objects:
            outline = self._outline(thing, frame)
            if "fill" in thing:
                yield Layer(outline, thing["fill"])
            if "stroke" in thing:
                yield Layer(outline, thing["stroke"], thing["width"])

    def _outline(self, thing, frame):
        turn, origin = self._placement(thing, frame)
        drawings = [(time, sum(self._drawings[name], [])) for time, name in thing["drawing"]]
        numbers = self._value(drawings, frame)
        corners = [numbers[i:i + 6] for i in range(0, len(numbers), 6)]
        last = [] if thing.get("open") else corners[:1]
        return [[placed(point, turn, origin) for point in cubic(corner, following)]
                for corner, following in zip(corners, corners[1:] + last)]

    def _placement(self, thing, frame):
        """What points are multiplied by and what is then added, in the plane of complex numbers."""
        angle, = self._value([(time, [angle]) for time, angle in thing.get("rotation", [[0, 0]])], frame)
        turn = cmath.rect(1, math.radians(angle))
        origin = complex(*self._value(thing["position"], frame))
        if "parent" not in thing:
            return turn, origin
        outer_turn, outer_origin = self._placement(self._by_name[thing["parent"]], frame)
        return outer_turn * turn, outer_turn * origin + outer_origin

    def _value(self, keys, frame):
        """Each number of the keys before and behind `frame`, tweened."""
        time, value = keys[0]
        for next_time, next_value in keys[1:]:
            if time <= frame < next_time:
                way = eased(self._law, (frame - time) / (next_time - time))
                return [a + (b - a) * way for a, b in zip(value, next_value)]
            time, value = next_time, next_value
        return value


def cubic(corner, following):
    x, y, _, _, out_x, out_y = corner
    next_x, next_y, in_x, in_y, _, _ = following
    return [(x, y), (x + out_x, y + out_y), (next_x + in_x, next_y + in_y), (next_x, next_y)]


def placed(point, turn, origin):
    place = complex(*point) * turn + origin
    return place.real, place.imag


def eased(law, share):
    """The ordinate of the curve (0, 0), law[0:2], law[2:4], (1, 1) where its abscissa is `share`."""
    if law == "linear":
        return share
    low, high = 0.0, 1.0
    for _ in range(50):
        middle = (low + high) / 2
        if bernstein(law[0], law[2], middle) < share:
            low = middle
        else:
            high = middle
    return bernstein(law[1], law[3], low)


def bernstein(first, second, t):
    return 3 * (1 - t) ** 2 * t * first + 3 * (1 - t) * t ** 2 * second + t ** 3
