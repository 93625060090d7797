"""What tests share in which calls of the command fail, by failing_calls.c. Called like
<name>_test.py <kfast> <pretend_board> <failing_calls.so>."""

import os
import pathlib
import subprocess
import sys

FAILING = pathlib.Path(sys.argv.pop(3)).resolve()
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "commands"))

from command_case import KFAST, ROOT  # noqa: E402 (each takes its own from the arguments)
from device_case import DeviceTest  # noqa: E402

BEFORE = b"what was there before"
DRAWING = ROOT / "tests/import/svg/circles-and-ellipses.svg"
FILM = ROOT / "tests/import/lottie/groups.json"


class FailingTest(DeviceTest):
    def setUp(self):
        super().setUp()
        self.output = self.folder / "output"

    def run_failing(self, arguments, calls, first=0, is_each=False, error=0):
        """Returns what the command did, and how many of those calls there were."""
        self.output.write_bytes(BEFORE)
        reader, writer = os.pipe()
        environment = {**os.environ, "LD_PRELOAD": str(FAILING), "FAILING_CALLS": calls, "FAILING_FROM": str(first),
                       "FAILING_ERROR": str(error), "FAILING_REPORT": str(writer)}
        if is_each:
            environment["FAILING_EACH"] = "1"
        result = subprocess.run([KFAST, *map(str, arguments)], cwd=self.folder, env=environment, capture_output=True,
                                text=True, timeout=60, pass_fds=[writer])
        os.close(writer)
        with os.fdopen(reader) as report:
            counted = report.read()
        return result, int(counted or 0)

    def check_failing(self, arguments, calls, first, whole, is_last=False, **more):
        """Either the command refuses with a message and leaves everything as it was, or it does without that call and
        does what it does otherwise: `whole` is what it writes then. Where `is_last`, it may refuse after it has written.
        Returns what it said."""
        entries = sorted(self.folder.iterdir())
        result, _ = self.run_failing(arguments, calls, first, **more)
        about = f"kfast {arguments[0]}, {calls} {first} {more}: status {result.returncode}, {result.stderr}"
        self.assertIn(result.returncode, (0, 1), about)
        self.assertEqual(sorted(self.folder.iterdir()), entries, about)
        content = self.output.read_bytes()
        if result.returncode == 0:
            self.assertEqual(content, whole, about)
        else:
            self.assertTrue(result.stderr.startswith("kfast: ") and result.stderr.endswith("\n"), about)
            self.assertIn(content, (BEFORE, whole) if is_last else (BEFORE,), about)
        return result

    def whole(self, arguments, calls):
        """What the command writes if nothing fails, and how many of those calls it makes."""
        result, number = self.run_failing(arguments, calls)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertGreater(number, 0)
        return self.output.read_bytes(), number
