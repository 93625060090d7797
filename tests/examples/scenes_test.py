"""Every scene of examples/ is good, moves, and is listed: scenes_test.py <kfast>."""

import pathlib
import subprocess
import sys
import unittest

KFAST = sys.argv.pop(1)
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"
SCENES = sorted(EXAMPLES.rglob("*.kfast"))


def kfast(*arguments):
    return subprocess.run([KFAST, *map(str, arguments)], capture_output=True, text=True, check=True, timeout=120).stdout


class ScenesTest(unittest.TestCase):
    def test_there_are_scenes(self):
        self.assertGreater(len(SCENES), 8)

    def test_they_compile_without_a_warning(self):
        for scene in SCENES:
            with self.subTest(scene=scene.name):
                self.assertIn(", 0 warnings", kfast("check", scene))

    def test_they_move(self):
        for scene in SCENES:
            with self.subTest(scene=scene.name):
                frames = {line.split()[-1] for line in kfast("hash", scene).splitlines()}
                self.assertGreater(len(frames), 7)

    def test_they_are_listed_and_begin_with_a_comment(self):
        listed = (EXAMPLES / "README.md").read_text()
        for scene in SCENES:
            with self.subTest(scene=scene.name):
                self.assertIn(f"({scene.relative_to(EXAMPLES)})", listed)
                self.assertTrue(scene.read_text().startswith("// "))


if __name__ == "__main__":
    unittest.main()
