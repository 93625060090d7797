"""Holds what kfast draws against the definition of coverage and against an independent renderer; see README.md:

    accuracy_test.py <kfast> <motion.json> <folder of frames NAME-NN.png> <scene.kfast or .json>...
"""

import pathlib
import subprocess
import sys
import tempfile

from PIL import Image

from chords import chords
from comparison import Comparison, on_panel, painted
from motion import Motion
from round_pen import coverage_by_pen
from true_area import coverage

FRAMES = 60
STEP = 5

# What kfast is held to. README.md beside it says why the independent renderer is further away.
CLOSE_TO_TRUE = 0.99
FARTHEST_FROM_TRUE = 32
CLOSE_TO_INDEPENDENT = {"eyes": 0.78, "morph": 0.86, "walker": 0.93}
FARTHEST_FROM_INDEPENDENT = 64

# More are no edges: a colour is wrong.
MOST_EDGES = 0.03

# Curves are halved until their control points lie this close to the chord, in pixels.
TRUE_TOLERANCE = 1 / 256
INDEPENDENT_TOLERANCE = 1 / 6
CLOSE_TO_COARSE = 0.98


def render_all(kfast, scene, folder):
    subprocess.run([kfast, "render", scene, "--all", "-o", folder], check=True, stdout=subprocess.PIPE, timeout=120)
    return [on_panel(Image.open(pathlib.Path(folder) / f"{frame:04}.png")) for frame in range(FRAMES)]


def by_definition(motion, frame, size, tolerance):
    layers = [(covered_by(layer, size, tolerance), layer.colour) for layer in motion.layers(frame)]
    return painted(motion.background, layers, size)


def covered_by(layer, size, tolerance):
    ends = chords(layer.outline, tolerance)
    return coverage_by_pen(ends, layer.width, size) if layer.width else coverage(ends, size)


def compared(pairs, motion):
    result = Comparison(motion.colours)
    for one, other in pairs:
        result.add(one, other)
    return result


def failures(what, result, least_close, farthest):
    print(f"{what:35} {result}")
    if result.close < least_close:
        yield f"{what}: fewer than {least_close:.0%} are close"
    if result.farthest > farthest:
        yield f"{what}: a pixel is more than {farthest} away"
    if result.edge_share > MOST_EDGES:
        yield f"{what}: {result.edge_share:.0%} of all pixels are not plain"
    if result.wrong_plain:
        yield f"{what}: plain pixels differ"


def test(kfast, motion_file, references, *scenes):
    name = pathlib.Path(motion_file).stem
    motion = Motion(pathlib.Path(motion_file))
    drawn = {}
    for scene in scenes:
        with tempfile.TemporaryDirectory() as folder:
            drawn[pathlib.Path(scene).name] = render_all(kfast, scene, folder)
    size = next(iter(drawn.values()))[0].size
    true = [by_definition(motion, frame, size, TRUE_TOLERANCE) for frame in range(FRAMES)]
    sampled = range(0, FRAMES, STEP)
    independent = [on_panel(Image.open(pathlib.Path(references) / f"{name}-{frame:02}.png")) for frame in sampled]
    coarse = [by_definition(motion, frame, size, INDEPENDENT_TOLERANCE) for frame in sampled]

    for scene, pictures in drawn.items():
        yield from failures(f"{scene}: kfast, true area", compared(zip(pictures, true), motion),
                            CLOSE_TO_TRUE, FARTHEST_FROM_TRUE)
        yield from failures(f"{scene}: kfast, independent", compared(zip(pictures[::STEP], independent), motion),
                            CLOSE_TO_INDEPENDENT[name], FARTHEST_FROM_INDEPENDENT)
    print(f"{name + ': true area, independent':35} {compared(zip(true[::STEP], independent), motion)}")
    yield from failures(f"{name}: coarse chords, independent", compared(zip(coarse, independent), motion),
                        CLOSE_TO_COARSE, FARTHEST_FROM_INDEPENDENT)


def main(*arguments):
    found = list(test(*arguments))
    print("\n".join(found) if found else "as accurate as it was")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
