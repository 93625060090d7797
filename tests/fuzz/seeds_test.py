"""Compiled scenes that fuzzers begin with are scenes: one that is refused leads nowhere. Fonts are those that we make.

    seeds_test.py KFAST
"""
import pathlib
import subprocess
import sys
import unittest

import font_seeds

SEEDS = pathlib.Path(__file__).parent / "corpus/scene_view"
BROKEN = {"cut.kfb": "breaks off before its end"}  # on purpose


class Seeds(unittest.TestCase):
    def test_they_are_scenes_of_the_present_format(self):
        seeds = sorted(SEEDS.glob("*.kfb"))
        self.assertGreater(len(seeds), 15)
        for seed in seeds:
            done = subprocess.run([sys.argv[1], "info", seed], capture_output=True, text=True)
            with self.subTest(seed.name):
                if seed.name in BROKEN:
                    self.assertIn(BROKEN[seed.name], done.stderr)
                else:
                    self.assertEqual("", done.stderr)
                    self.assertEqual(0, done.returncode)

    def test_fonts_are_those_that_are_made(self):
        folder = pathlib.Path(__file__).parent / "corpus/font"
        self.assertEqual(font_seeds.fonts(), {file.name: file.read_bytes() for file in folder.iterdir()})


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
