"""The fit report's estimate is within 15 % of what QEMU counts, for every example:

    estimate_test.py <folder of kfast and kfast-work> <folder of the bench images>
"""

import concurrent.futures
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import guest  # noqa: E402
from scenes import compile_scenes  # noqa: E402

HOST, IMAGES = (pathlib.Path(argument) for argument in sys.argv[1:3])
CPUS = ("cortex-m0", "cortex-m4", "cortex-m33")
TOLERANCE = {"median": 0.15, "worst": 0.2}


def estimates(scene):
    """Instructions of each frame, by processor."""
    told = subprocess.run([HOST / "kfast-work", scene.compiled], check=True, stdout=subprocess.PIPE, text=True, timeout=300)
    head, *rows = (line.split() for line in told.stdout.splitlines())
    return {cpu: [int(row[head.index(cpu)]) for row in rows] for cpu in CPUS}


def counts(cpu, scene):
    run = guest.play(IMAGES, cpu, scene.compiled)
    return [sum(frame[phase] for phase in ("update", "draw", "send")) for frame in run.frames]


class Estimate(unittest.TestCase):
    def test_of_every_example(self):
        with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            scenes = compile_scenes(HOST / "kfast", [], folder)
            self.assertGreater(len(scenes), 15)
            jobs = [(cpu, scene) for scene in scenes for cpu in CPUS]
            for (cpu, scene), counted in zip(jobs, pool.map(lambda job: counts(*job), jobs)):
                estimated = estimates(scene)[cpu]
                for what, figure in (("median", statistics.median), ("worst", max)):
                    with self.subTest(scene=scene.name, cpu=cpu, frame=what):
                        self.assertAlmostEqual(figure(estimated) / figure(counted), 1, delta=TOLERANCE[what])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
