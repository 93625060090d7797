"""What moves in a scene, as numbers: see README.md for the files. Points are (x, y) in pixels."""

import json


class Motion:
    def __init__(self, file):
        scene = json.loads(file.read_text(encoding="utf-8"))
        self.fill = scene["fill"]
        self._law = scene["law"]
        self._objects = scene["objects"]
        self._drawings = scene["drawings"]

    def outlines(self, frame):
        """The closed outline of each object, as cubics of four points, the first object lowest."""
        return [self._outline(thing, frame) for thing in self._objects]

    def _outline(self, thing, frame):
        left, top = self._value(thing["position"], frame)
        drawings = [(time, sum(self._drawings[name], [])) for time, name in thing["drawing"]]
        numbers = self._value(drawings, frame)
        corners = [numbers[i:i + 6] for i in range(0, len(numbers), 6)]
        return [cubic(corner, following, left, top)
                for corner, following in zip(corners, corners[1:] + corners[:1])]

    def _value(self, keys, frame):
        """Each number of the keys before and behind `frame`, tweened."""
        time, value = keys[0]
        for next_time, next_value in keys[1:]:
            if time <= frame < next_time:
                way = eased(self._law, (frame - time) / (next_time - time))
                return [a + (b - a) * way for a, b in zip(value, next_value)]
            time, value = next_time, next_value
        return value


def cubic(corner, following, left, top):
    x, y, _, _, out_x, out_y = corner
    next_x, next_y, in_x, in_y, _, _ = following
    return [(left + x, top + y), (left + x + out_x, top + y + out_y),
            (left + next_x + in_x, top + next_y + in_y), (left + next_x, top + next_y)]


def eased(law, share):
    """The ordinate of the curve (0, 0), law[0:2], law[2:4], (1, 1) where its abscissa is `share`."""
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
