"""Runs the programs of examples/library: library_test.py <folder of the programs> <kfast>."""

import pathlib
import subprocess
import sys
import tempfile
import unittest
import zlib

from PIL import Image

KFAST = pathlib.Path(sys.argv.pop(2)).resolve()
PROGRAMS = pathlib.Path(sys.argv.pop(1)).resolve()
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"


def run(program, *arguments, text=True):
    return subprocess.run([program, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=text,
                          timeout=60)


def hashes_of(frames, size):
    return [f"{zlib.crc32(frames[at:at + size]):08x}" for at in range(0, len(frames), size)]


def greys_of_pgm(text):
    magic, width, height, white, *greys = text.split()
    return [magic, width, height, white], [int(grey) * 17 for grey in greys]


class Library(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="kfast")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)

    def test_morph_writes_the_strip_next_to_it(self):
        self.assertEqual(run(PROGRAMS / "morph").stdout, (EXAMPLES / "library/morph.svg").read_text())

    def test_track_passes_its_key_times(self):
        heights = dict(map(float, line.split()) for line in run(PROGRAMS / "track").stdout.splitlines())
        self.assertEqual(list(heights), [*range(25)])
        self.assertEqual([heights[frame] for frame in (0, 6, 12, 18, 24)], [0, 135, 180, 135, 0])
        self.assertEqual(heights[3], 56.25)

    def assert_frames(self, program, count, *options):
        frames = run(PROGRAMS / program, text=False).stdout
        printed = run(KFAST, "hash", EXAMPLES / "robot-eyes.kfast", *options).stdout
        self.assertEqual(hashes_of(frames, 2 * 240 * 240), [line.split()[1] for line in printed.splitlines()][:count])

    def test_eyes_draws_what_the_command_draws(self):
        self.assert_frames("eyes", 60)

    def test_wink_draws_what_the_command_draws(self):
        self.assert_frames("wink", 11, "--clip", "blink")

    def test_play_draws_what_the_command_draws(self):
        scene, picture = self.folder / "scene.kfb", self.folder / "picture.png"
        run(KFAST, "compile", EXAMPLES / "first-light.kfast", "-o", scene)
        for frame in (0, 20, 45):
            run(KFAST, "render", scene, "--frame", frame, "--panel", "ssd0323", "-o", picture)
            head, greys = greys_of_pgm(run(PROGRAMS / "play", scene, frame).stdout)
            self.assertEqual(head, ["P2", "128", "64", "15"])
            with Image.open(picture) as expected:
                self.assertEqual(greys, list(expected.convert("L").getdata()))

    def test_play_refuses_what_is_no_scene(self):
        scene = self.folder / "scene.kfb"
        scene.write_bytes(b"KFAST?")
        refused = run(PROGRAMS / "play", scene, 0)
        self.assertEqual((refused.returncode, refused.stdout), (1, ""))
        self.assertIn("scene.kfb", refused.stderr)


if __name__ == "__main__":
    unittest.main()
