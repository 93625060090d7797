"""Each drawing in this folder looks in kfast as librsvg draws it, but for what kfast says it has lost:

    svg_test.py KFAST RSVG_CONVERT

What librsvg 2.54 does not know is written in other words in plain/, for librsvg to draw."""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

FOLDER = pathlib.Path(__file__).parent
sys.path.insert(0, str(FOLDER.parent))
from compare_pictures import compare  # noqa: E402

KFAST, RSVG = "kfast", "rsvg-convert"

# What is lost of each drawing that is not carried over whole: features, and whose they are.
LOST = {
    "lost-gradients": {"gradient of rect", "gradient of circle"},
    "lost-text-and-images": {'text "Hello, world" of ', "<image> of ", "<foreignObject> of ", "<script> of ",
                             'script of "onclick" of stays', "<blob> of "},
    "lost-effects": {
        "@keyframes in a style sheet of ", "@media in a style sheet of ", 'selector "rect[x="3"]" of a style sheet of ',
        "filter of scene / soft-one", "pattern of scene / dotted", "marker of scene / arrow", "clip-path of scene / cut",
        "mask of scene / veiled", "mix-blend-mode of scene / mixed", 'property "quux" of scene / mixed',
        "line that is scaled unevenly of scene / leaning", 'fill "blurple" of scene / odd',
        'transform "rotate3d(1,1,1,45deg)" of scene / odd', 'attribute "glow" of scene / odd',
        "path data: a path command is expected here, at character 30 of broken", 'use of "nowhere" of use'},
}


def run(*command):
    done = subprocess.run([str(each) for each in command], capture_output=True, text=True, timeout=300)
    if done.returncode != 0:
        raise AssertionError(f"{command} failed:\n{done.stdout}{done.stderr}")
    return done.stdout


class Drawings(unittest.TestCase):
    def test_every_drawing(self):
        drawings = sorted(FOLDER.glob("*.svg"))
        self.assertGreater(len(drawings), 30)
        for drawing in drawings:
            with self.subTest(drawing=drawing.name), tempfile.TemporaryDirectory() as folder:
                self.check(drawing, pathlib.Path(folder))

    def check(self, drawing, folder):
        scene, ours, theirs = (folder / name for name in ("scene.kfast", "ours.png", "theirs.png"))
        report = json.loads(run(KFAST, "import", drawing, "-o", scene, "--json"))
        lost = {f"{loss['feature']} of {loss['layer']}" for loss in report["losses"]}
        self.assertEqual(lost, LOST.get(drawing.stem, set()))
        run(KFAST, "compile", scene, "-o", folder / "scene.kfb")
        if drawing.stem in LOST:
            return
        run(KFAST, "render", drawing, "--frame", "0", "-o", ours)
        plain = FOLDER / "plain" / drawing.name
        run(RSVG, "--background-color", "white", plain if plain.exists() else drawing, "-o", theirs)
        difference = compare(ours, theirs)
        self.assertEqual(difference.problems(), [], difference)


class KeyDrawings(unittest.TestCase):
    """The drawings of keys/ are the layers of keys/layers.svg."""

    TIMES = (0, 12, 24)
    POSES = [FOLDER / "keys" / f"pose-{time:02}.svg" for time in TIMES]

    def check(self, *what, times=TIMES, poses=POSES):
        """Each pose is seen at its time, and something else half way to the next."""
        with tempfile.TemporaryDirectory() as name:
            scene, ours, theirs = (pathlib.Path(name) / file for file in ("scene.kfast", "ours.png", "theirs.png"))
            report = json.loads(run(KFAST, "import", *what, "-o", scene, "--json", "--end", "once"))
            self.assertEqual(report["losses"], [])
            for time, pose in zip(times, poses):
                with self.subTest(pose=pose.name):
                    run(KFAST, "render", scene, "--time", str(time), "-o", ours)
                    run(RSVG, "--background-color", "white", pose, "-o", theirs)
                    difference = compare(ours, theirs)
                    self.assertEqual(difference.problems(), [], difference)
            for time, after in zip(times, times[1:]):
                run(KFAST, "render", scene, "--time", str((time + after) / 2), "-o", ours)
                run(RSVG, "--background-color", "white", poses[times.index(time)], "-o", theirs)
                self.assertTrue(compare(ours, theirs).problems(), f"nothing moves from {time} on")

    def test_files(self):
        self.check("--keys", *self.POSES, "--at", *self.TIMES)

    def test_layers(self):
        self.check(FOLDER / "keys" / "layers.svg")

    def test_examples(self):
        examples = sorted((FOLDER.parents[2] / "examples" / "import").glob("wink-*.svg"))
        times = (0, 8, 20, 30, 45)
        self.assertEqual(len(examples), len(times))
        self.check("--keys", *examples, "--at", *times, times=times, poses=examples)


if __name__ == "__main__":
    KFAST, RSVG = sys.argv[1:3]
    unittest.main(argv=sys.argv[:1])
