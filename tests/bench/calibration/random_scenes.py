"""Scenes of all sorts, the same in every run: what the cost table is calibrated on, besides the golden scenes."""

import random

COUNT = 40
ALIKE = 12
LAWS = ("constant", "accelerate", "decelerate", "accelerate-decelerate", "ease", "hold", '"steps(5)"',
        '"bezier(0.3,1.5,0.6,1)"')
COLOURS = ("red", "lime", "blue", "yellow", "aqua", "fuchsia", "white", "silver", '"#ff8000"', '"#40c0ff80"')
CANVASES = ((240, 240), (160, 128), (320, 240), (128, 64), (96, 96))
MOVES = (("x", -30, 30), ("y", -30, 30), ("rotate", -180, 180), ("scale-x", 0.5, 1.5), ("opacity", 0.2, 1))


class Sketch:
    """Writes one scene."""

    def __init__(self, seed):
        self.random = random.Random(seed)
        self.kinds = self.random  # chooses shapes, and how many points they have
        self.width, self.height = self.random.choice(CANVASES)
        self.frames = self.random.choice((16, 24, 30))
        self.crowd = self.random.choice((1, 2, 4, 8, 16))  # items

    def number(self, low, high):
        return f"{self.random.uniform(low, high):.2f}"

    def place(self, between=" "):
        return f"{self.number(0, self.width)}{between}{self.number(0, self.height)}"

    def length(self, low, high):
        """In hundredths of the canvas."""
        return self.number(low * min(self.width, self.height) / 100, high * min(self.width, self.height) / 100)

    def places(self, fewest, most):
        return " ".join(self.place() for _ in range(self.kinds.randint(fewest, most)))

    def curves(self):
        parts = [f"M {self.place()}"]
        parts += [f"C {self.place()} {self.place()} {self.place()}" for _ in range(self.kinds.randint(1, 5))]
        return f'path "{" ".join(parts)}{self.kinds.choice((" Z", ""))}"'

    def shape(self, most):
        return self.kinds.choice((
            lambda: f"circle {self.place()} r={self.length(2, most)}",
            lambda: f"rect {self.place()} {self.length(4, most)} {self.length(4, most)} corner={self.length(0, 2)}",
            lambda: f"star {self.place()} points={self.kinds.randint(3, 9)} r={self.length(6, most)} inner={self.length(2, 5)}",
            lambda: f"line {self.places(2, 9)}",
            lambda: f"polygon {self.places(3, 8)}",
            lambda: f"curve {self.places(3, 7)}",
            self.curves,
            lambda: f"ellipse {self.place()} rx={self.length(3, most)} ry={self.length(2, most)}",
            lambda: f'text {self.kinds.choice(("KFAST", "OCR", "ok"))} at="{self.place(",")}" size={self.length(8, most)}',
        ))()

    def drawing(self, most):
        return "; ".join(self.shape(most) for _ in range(self.kinds.choice((1, 1, 1, 2, 3))))

    def drawings(self, count, most):
        return [self.drawing(most) for _ in range(count)]

    def style(self):
        wish = self.random.choice(("fill", "stroke", "both"))
        style = "" if wish == "stroke" else f" fill={self.random.choice(COLOURS)}"
        if wish != "fill":
            style += f" stroke={self.random.choice(COLOURS)} width={self.length(0.3, 5)}"
            style += f" cap={self.random.choice(('butt', 'round', 'square'))}"
            style += f" join={self.random.choice(('miter', 'round', 'bevel'))}"
        return style

    def key_times(self):
        return [0, *sorted(self.random.sample(range(2, self.frames - 1), self.random.choice((0, 1, 1, 2, 4)))), self.frames]

    def object(self, name):
        most = self.random.choice((8, 20, 45))
        law = f"law={self.random.choice(LAWS)}"
        times = [0] if self.random.random() < 0.3 else self.key_times()
        keys = [f"key {time}{f' {law}' if time else ''} {{ {drawing} }}"
                for time, drawing in zip(times, self.drawings(len(times), most))]
        return "\n    ".join([f"object {name}{self.style()} {{", *keys, *self.tracks()]) + "\n}"

    def tracks(self):
        def track(name, low, high):
            return f"track {name} {{ " + "; ".join(f"at {time} {self.number(low, high)}" for time in self.key_times()) + " }"

        tracks = [track(*move) for move in MOVES if self.random.random() < 0.15]
        return tracks + ([track("rotate-y", -90, 90)] if self.random.random() < 0.08 else [])

    def group(self, name):
        inner = [self.object(f"{name}-{i}") for i in range(self.random.randint(1, 3))]
        keys = [f"key {time} law={self.random.choice(LAWS)} x={self.number(-20, 20)} rotate={self.number(-40, 40)}"
                for time in self.key_times()]
        return "\n".join([f"group {name}{self.random.choice(('', '', ' opacity=0.5'))} {{", *inner, *keys, "}"])

    def item(self, number):
        return self.group(f"g{number}") if self.random.random() < 0.2 else self.object(f"o{number}")

    def text(self):
        items = [self.item(number) for number in range(self.random.randint(1, self.crowd))]
        return "\n".join([f"kfast 1\ncanvas {self.width} {self.height} frames={self.frames} background=black", *items, ""])


class AlikeSketch(Sketch):
    """All keys of an object have the same shapes in other places, as most of what people draw."""

    def drawings(self, count, most):
        seed = self.random.random()
        drawings = []
        for _ in range(count):
            self.kinds = random.Random(seed)
            drawings.append(self.drawing(most))
        self.kinds = self.random
        return drawings


def scene_texts():
    return {**{f"random-{seed}": Sketch(seed).text() for seed in range(COUNT)},
            **{f"alike-{seed}": AlikeSketch(seed).text() for seed in range(ALIKE)}}
