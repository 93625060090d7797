"""Animated PNGs that kfast render makes, read by Pillow and chunk by chunk."""

import fractions
import unittest

from PIL import Image

from render_case import RenderTest


def chunks(png):
    at = 8
    while at < len(png):
        length = int.from_bytes(png[at:at + 4], "big")
        yield png[at + 4:at + 8].decode(), png[at + 8:at + 8 + length]
        at += 12 + length


class AnimatedPngTest(RenderTest):
    def controls(self, name):
        """Rectangle and delay of each picture."""
        found = []
        for kind, data in chunks((self.folder / name).read_bytes()):
            if kind == "fcTL":
                word = [int.from_bytes(data[i:i + 4], "big") for i in range(4, 20, 4)]
                found.append((tuple(word), fractions.Fraction(int.from_bytes(data[20:22], "big"),
                                                              int.from_bytes(data[22:24], "big"))))
        return found

    def test_pictures_loops_and_delays(self):
        for loop, count, plays in (("repeat", 10, 0), ("once", 11, 1), ("ping-pong", 20, 0)):
            for name in ("out.apng", "out.png"):
                self.render(f"{loop}.kfast", "--all", "-o", name)
            self.assertEqual((self.folder / "out.apng").read_bytes(), (self.folder / "out.png").read_bytes())
            with Image.open(self.folder / "out.apng") as image:
                self.assertEqual((image.n_frames, image.info["loop"]), (count, plays))
            shown = [pixels for _, pixels in self.pictures("out.apng")]
            played = self.frames(f"{loop}.kfast")
            self.assertEqual(shown[:len(played)], played)
            self.assertEqual({delay for _, delay in self.controls("out.apng")}, {fractions.Fraction(1, 30)})

    def test_resting_pictures_are_one_and_the_rest_is_what_changes(self):
        self.render("resting-once.kfast", "--all", "-o", "out.apng")
        frame = fractions.Fraction(100, 2997)
        self.assertEqual([delay / frame for _, delay in self.controls("out.apng")], [1, 1, 1, 3, 1])
        whole, *parts = [area for area, _ in self.controls("out.apng")]
        self.assertEqual(whole, (21, 11, 0, 0))
        self.assertEqual(parts[-1], (10, 7, 7, 1))
        self.assertEqual([pixels for _, pixels in self.pictures("out.apng")][-1], self.frames("resting-once.kfast")[-1])

    def test_scaled(self):
        self.render("resting-repeat.kfast", "--all", "--scale", "3", "-o", "large.png")
        self.render("resting-repeat.kfast", "--all", "-o", "small.png")
        large, small = self.pictures("large.png"), self.pictures("small.png")
        self.assertEqual(len(large), len(small))
        for (_, wide), (_, narrow) in zip(large, small):
            self.assertEqual(Image.frombytes("RGB", (21, 11), narrow).resize((63, 33), Image.NEAREST).tobytes(), wide)


if __name__ == "__main__":
    unittest.main()
