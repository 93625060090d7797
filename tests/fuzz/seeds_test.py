"""Compiled scenes that fuzzers and mutations begin with are scenes: one that is refused leads nowhere. Whatever a compiled
scene may hold is in one of them. Fonts are those that we make.

    seeds_test.py KFAST SEED_KINDS
"""
import pathlib
import re
import subprocess
import sys
import unittest

import font_seeds

FUZZ = pathlib.Path(__file__).parent
SEEDS = FUZZ / "corpus/scene_view"
BROKEN = {"cut.kfb": "breaks off before its end"}  # on purpose
# Of docs/format.md, what is in each scene, and what is no part of one.
EVERYWHERE = {"Keys", "Values"}
NO_PARTS = {"Time", "Memory"}


def run(*command):
    return subprocess.run([*map(str, command)], capture_output=True, text=True, timeout=120)


def sections_of_the_format():
    page = (FUZZ.parents[1] / "docs/format.md").read_text()
    return set(re.findall(r"^##+ (.*)$", page, re.MULTILINE)) - EVERYWHERE - NO_PARTS


class Seeds(unittest.TestCase):
    def test_they_are_scenes_of_the_present_format(self):
        seeds = sorted(SEEDS.glob("*.kfb"))
        self.assertGreater(len(seeds), 15)
        for seed in seeds:
            done = run(KFAST, "info", seed)
            with self.subTest(seed.name):
                if seed.name in BROKEN:
                    self.assertIn(BROKEN[seed.name], done.stderr)
                else:
                    self.assertEqual("", done.stderr)
                    self.assertEqual(0, done.returncode)

    def test_whatever_a_scene_may_hold_is_in_one_of_them(self):
        done = run(SEED_KINDS, SEEDS)
        self.assertEqual("", done.stderr)
        self.assertEqual(0, done.returncode)

    def test_one_scene_has_every_section_of_the_format(self):
        found = {line.split(":")[0] for line in run(SEED_KINDS, SEEDS / "everything.kfb").stdout.splitlines()}
        self.assertEqual(sections_of_the_format(), found)

    def test_that_one_is_its_text(self):
        pictures = [run(KFAST, "hash", file).stdout for file in (FUZZ / "scenes/everything.kfast", SEEDS / "everything.kfb")]
        self.assertGreater(len(pictures[0]), 100)
        self.assertEqual(*pictures, "Compile the text anew: kfast compile TEXT -o SEED")

    def test_fonts_are_those_that_are_made(self):
        folder = FUZZ / "corpus/font"
        self.assertEqual(font_seeds.fonts(), {file.name: file.read_bytes() for file in folder.iterdir()})


if __name__ == "__main__":
    KFAST, SEED_KINDS = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1])
