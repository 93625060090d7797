"""scripts/fuzz with a real target, for a second; tests/scripts/fuzz_test.py has the rest, with pretended ones:

    real_fuzzer_test.py <fuzz_targets.json>
"""

import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

TARGETS = sys.argv.pop(1)
FUZZ = pathlib.Path(__file__).with_name("fuzz.py")
SEEDS = FUZZ.parents[1] / "corpus/ilda"


class RealFuzzerTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="kfast")
        self.addCleanup(temporary.cleanup)
        self.kept = pathlib.Path(temporary.name) / "corpora/ilda"
        self.command = [sys.executable, FUZZ, "--targets", TARGETS, "--folder", temporary.name, "--jobs", "1"]
        self.seeds = sorted(SEEDS.iterdir())

    def test_its_figures_are_understood_and_its_corpus_is_minimized(self):
        done = subprocess.run([*self.command, "0.02", "ilda"], capture_output=True, text=True, timeout=120, check=False)
        self.assertEqual(0, done.returncode, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"(?m)^ilda +\d+ +[1-9]\d* +\d+ +[1-9]\d* -> \d+ +[1-9]\d* -> \d+ +[1-9]\d* +0$")
        self.assertEqual(["ilda"], [folder.name for folder in self.kept.parent.iterdir()])
        self.assertEqual(self.seeds, sorted(SEEDS.iterdir()))

    def test_it_tells_its_figures_when_it_is_interrupted(self):
        process = subprocess.Popen([*self.command, "5", "ilda"], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        deadline = time.monotonic() + 60
        while not self.kept.exists() or not list(self.kept.iterdir()):
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.05)
        process.send_signal(signal.SIGINT)
        printed, errors = process.communicate(timeout=60)
        self.assertEqual(130, process.returncode, printed + errors)
        self.assertRegex(printed, r"(?m)^ilda +\d+ +[1-9]\d* .* 0$")


if __name__ == "__main__":
    unittest.main()
