"""What the tests of commands about devices share: boards behind sockets. Called like <name>_test.py <kfast> <pretend_board>."""

import contextlib
import json
import pathlib
import subprocess
import sys

from command_case import KFAST, CommandTest

BOARD = pathlib.Path(sys.argv.pop(1)).resolve()

# Kinds of reports, as docs/link.md has them.
BEGIN, DATA, COMMIT, CANCEL = 0x10, 0x11, 0x12, 0x13
CHOOSE, PLAY, PAUSE, SPEED, INPUTS, SILENCE, BOOT = 0x22, 0x30, 0x31, 0x34, 0x36, 0x3A, 0x3F

KNOBS = """kfast 1
canvas 64 48 fps=30 frames=60
input gaze min=-1 max=1
input "left lid" min=0 max=100
object sun fill=yellow { circle 10 24 r=8; track x input=gaze { at -1 0; at 1 40 } }
object lid fill=red { rect 1 1 9 9; track y input="left lid" { at 0 0; at 100 30 } }
clip rise from=10 to=30
"""

NO_DEVICE, NO_PERMISSION, UNPLUGGED, WRONG_VERSION, NO_ROOM, REFUSED, TIMED_OUT, INTERRUPTED = 3, 4, 5, 6, 7, 8, 9, 130


class Board:
    def __init__(self, folder, name, *options):
        self.socket = folder / f"{name}.sock"
        self.log = folder / f"{name}.log"
        self.process = subprocess.Popen([BOARD, self.socket, "--log", self.log, "--serial", name, *map(str, options)],
                                        stdout=subprocess.PIPE, text=True)
        assert self.process.stdout.readline() == "ready\n"

    def stop(self):
        self.process.kill()
        self.process.wait()
        self.process.stdout.close()

    def lines(self):
        return self.log.read_text().splitlines()

    def reports(self, *kinds):
        """Those that have come, of some kinds or all, as bytes."""
        all_of_them = [bytes.fromhex(line) for line in self.lines() if line != "gone"]
        return [report for report in all_of_them if not kinds or report[0] in kinds]


class DeviceTest(CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "knobs.kfast").write_text(KNOBS)
        self.device = ()  # all boards, for the command line

    def board(self, name="A", *options):
        board = Board(self.folder, name, *options)
        self.addCleanup(board.stop)
        self.device = (*self.device, "--device", f"sim:{board.socket}")
        return board

    def ask(self, command, *arguments, **more):
        return self.run_kfast(command, *arguments, *self.device, **more)

    def told(self, command, *arguments):
        return json.loads(self.ask(command, *arguments, "--json").stdout)

    def start(self, *arguments):
        """The running command."""
        process = subprocess.Popen([KFAST, *map(str, arguments), *map(str, self.device)], cwd=self.folder, text=True,
                                   stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(self.end, process)
        return process

    @staticmethod
    def end(process):
        process.kill()
        process.wait()
        for pipe in (process.stdin, process.stdout, process.stderr):
            with contextlib.suppress(BrokenPipeError):
                pipe.close()

    def refused(self, *arguments, status, says):
        result = self.ask(*arguments, status=status)
        self.assertIn(says, result.stderr)
        self.assertTrue(result.stderr.startswith("kfast: "))
