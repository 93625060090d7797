"""The fit report's estimate for a beam is within 15 % of what QEMU counts:

    beam_estimate_test.py <kfast> <folder of the bench images>
"""

import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import guest  # noqa: E402
from scenes import REFERENCES, compile_scenes  # noqa: E402

KFAST, IMAGES = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
CPU = "cortex-m0"
DRAWN_FOR_BEAMS = ("jitterbug", "beam-word", "lissajous", "marcher")
OTHERS = ("gauge", "first-light", "stroller", "card", "one-to-two")
TOLERANCE = 0.2


def estimates(scene):
    """Instructions by frame, of the picture with most points and of the median one."""
    told = subprocess.run([KFAST, "fit", scene.compiled, "--board", "pico-xy", "--json"], stdout=subprocess.PIPE, text=True,
                          timeout=300).stdout
    report = json.loads(told)
    return {picture["frame"]: picture["instructions"] for picture in (report["busiest"], report["median"])}


def counts(scene):
    run = guest.play(IMAGES, CPU, scene.compiled, program="beam")
    return {frame["frame"]: frame["update"] + frame["draw"] for frame in run.frames}


class Estimate(unittest.TestCase):
    def test_of_scenes_without_inputs(self):
        with tempfile.TemporaryDirectory() as folder:
            for scene in compile_scenes(KFAST, [*REFERENCES, *DRAWN_FOR_BEAMS, *OTHERS], folder):
                counted = counts(scene)
                for frame, estimated in estimates(scene).items():
                    with self.subTest(scene=scene.name, frame=frame):
                        self.assertAlmostEqual(estimated / counted[frame], 1, delta=TOLERANCE)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
