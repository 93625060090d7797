"""Shows what compare_pictures.py notices, and what it does not mind: compare_pictures_test.py"""

import unittest

from PIL import Image, ImageDraw

from compare_pictures import compare

SIZE = 120


def disc(x=60.0, y=60.0, radius=30.0, colour="#e0a030", fine=8, background="#102030"):
    """Drawn `fine` times as large and made smaller, so that its edges are smooth."""
    large = Image.new("RGB", (SIZE * fine, SIZE * fine), background)
    box = [fine * (x - radius), fine * (y - radius), fine * (x + radius) - 1, fine * (y + radius) - 1]
    ImageDraw.Draw(large).ellipse(box, fill=colour)
    return large.resize((SIZE, SIZE), Image.Resampling.BOX)


def line(x, width, colour="white"):
    picture = Image.new("RGB", (SIZE, SIZE), "black")
    ImageDraw.Draw(picture).line([(x, 10), (x, 110)], fill=colour, width=width)
    return picture


class ComparePictures(unittest.TestCase):
    def alike(self, one, other, **background):
        difference = compare(one, other, **background)
        self.assertEqual([], difference.problems(), difference)

    def different(self, one, other):
        difference = compare(one, other)
        self.assertTrue(difference.problems(), difference)
        return difference

    def test_a_picture_is_like_itself(self):
        difference = compare(disc(), disc())
        self.assertEqual((difference.near, difference.worst, difference.mean), (1, 0, 0))

    def test_antialiasing_is_not_minded(self):
        for fine in (2, 3, 4, 16):
            with self.subTest(fine=fine):
                self.alike(disc(), disc(fine=fine))

    def test_a_sixteenth_of_a_pixel_is_not_minded(self):
        self.alike(disc(fine=16), disc(x=60 + 1 / 16, y=60 - 1 / 16, fine=16))

    def test_a_level_of_rounding_is_not_minded(self):
        self.alike(disc(colour="#e0a030"), disc(colour="#e1a12f"))

    def test_a_missing_shape_is_noticed(self):
        self.different(disc(), Image.new("RGB", (SIZE, SIZE), "#102030"))
        self.different(disc(radius=3), Image.new("RGB", (SIZE, SIZE), "#102030"))

    def test_a_missing_hair_line_is_noticed(self):
        self.different(line(60, 1), Image.new("RGB", (SIZE, SIZE), "black"))

    def test_a_pixel_off_is_noticed(self):
        self.different(disc(), disc(x=61))
        self.different(disc(), disc(y=59))
        self.different(line(60, 1), line(61, 1))
        self.different(line(60, 6), line(61, 6))

    def test_another_size_is_noticed(self):
        self.different(disc(), disc(radius=31))
        self.different(line(60, 3), line(60, 5))

    def test_another_colour_is_noticed(self):
        self.different(disc(), disc(colour="#e0a070"))
        self.different(disc(radius=3), disc(radius=3, colour="#3080ff"))
        self.different(disc(), disc(background="#102050"))

    def test_the_place_is_told(self):
        at = self.different(disc(), disc(x=30, radius=4)).at
        self.assertTrue(28 <= at[0] <= 90 and 28 <= at[1] <= 90, at)

    def test_what_is_transparent_shows_the_background(self):
        clear = Image.new("RGBA", (SIZE, SIZE), (255, 0, 0, 0))
        self.alike(clear, Image.new("RGB", (SIZE, SIZE), "navy"), background="navy")

    def test_pictures_of_two_sizes_are_refused(self):
        with self.assertRaisesRegex(ValueError, "120 x 120"):
            compare(disc(), Image.new("RGB", (10, 10)))


if __name__ == "__main__":
    unittest.main()
