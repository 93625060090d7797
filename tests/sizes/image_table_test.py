"""Shows that image_table.py notices growth: image_table_test.py"""

import unittest

import image_table

TABLE = {"board": {"flash": 10000, "ram": 500, "stack": 900}}


def with_figure(what, figure):
    return {"board": {**TABLE["board"], what: figure}}


class ImageTable(unittest.TestCase):
    def test_what_is_recorded_is_right(self):
        self.assertEqual([], image_table.complaints(TABLE, TABLE))

    def test_growth_within_the_tolerance_is_right(self):
        for what, figure in (("flash", 10100), ("ram", 564), ("stack", 964)):
            self.assertEqual([], image_table.complaints(TABLE, with_figure(what, figure)))

    def test_growth_beyond_it_is_told(self):
        for what, figure in (("flash", 10101), ("ram", 565), ("stack", 965)):
            self.assertEqual([f"board: {what}: {figure} bytes instead of {TABLE['board'][what]}"],
                             image_table.complaints(TABLE, with_figure(what, figure)))

    def test_a_stack_that_nobody_can_tell_is_told(self):
        self.assertEqual(["board: stack: None bytes instead of 900"],
                         image_table.complaints(TABLE, with_figure("stack", None)))

    def test_an_image_that_got_much_smaller_is_to_be_recorded(self):
        self.assertEqual(1, len(image_table.complaints(TABLE, with_figure("flash", 9499))))
        self.assertEqual([], image_table.complaints(TABLE, with_figure("flash", 9500)))

    def test_images_that_are_new_or_gone_are_told(self):
        self.assertEqual(["board: not recorded"], image_table.complaints({}, TABLE))
        self.assertEqual(["board: not measured"], image_table.complaints(TABLE, {}))

    def test_the_document_shows_the_table(self):
        document = f"a\n{image_table.BEGIN}old\n{image_table.END}b\n"
        shown = image_table.with_table(document, TABLE)
        self.assertIn("| `board` | 10,000 | 500 | 900 |", shown)
        self.assertEqual(shown, image_table.with_table(shown, TABLE))


if __name__ == "__main__":
    unittest.main()
