"""What the tests of the real command share. They are called with its path: <name>_test.py <kfast>."""

import fcntl
import os
import pathlib
import pty
import resource
import struct
import subprocess
import sys
import tempfile
import termios
import unittest

KFAST = pathlib.Path(sys.argv.pop(1)).resolve()
ROOT = pathlib.Path(__file__).resolve().parents[3]

SCENE = """kfast 1
canvas 60 40 fps=30 loop={loop}
object dot fill="#f2f2f2" {{
    key 0 {{ rect 1 1 14 14 }}
    key 4 {{ rect 40 1 14 14 }}
    key 10 {{ rect 1 20 14 14 }}
}}
"""

# Clips and events; the dot is somewhere else at every moment.
MARKED = """kfast 1
canvas 60 40 fps=30 loop=repeat
object dot fill="#f2f2f2" {
    key 0 { rect 1 1 14 14 }
    key 10 { rect 41 21 14 14 }
}
clip blink from=2 to=6
clip sway from=4 to=10 loop=ping-pong
event 0 begin
event 2.5 "lid down"
event 4 shut
event 4 shut2
event 9.5 late
"""


def kfast(*arguments, folder, environment=None, limit=None):
    def restrict():
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    return subprocess.run([KFAST, *map(str, arguments)], cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                          text=True, timeout=120, env={**os.environ, **(environment or {})},
                          preexec_fn=restrict if limit else None)


class CommandTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="kfast")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        for loop in ("repeat", "once", "ping-pong"):
            (self.folder / f"{loop}.kfast").write_text(SCENE.format(loop=loop))
        (self.folder / "marked.kfast").write_text(MARKED)

    def run_kfast(self, *arguments, status=0, **more):
        result = kfast(*arguments, folder=self.folder, **more)
        self.assertEqual(result.returncode, status, f"kfast {arguments}: {result.stdout}{result.stderr}")
        return result

    def refuse(self, *arguments, status, says, **more):
        before = sorted(self.folder.rglob("*"))
        result = self.run_kfast(*arguments, status=status, **more)
        self.assertIn(says, result.stderr)
        self.assertTrue(result.stderr.endswith("\n"))
        self.assertEqual(sorted(self.folder.rglob("*")), before, "a refused command leaves no file")

    def written_to_a_terminal(self, *arguments, stream="stderr", columns=80, environment=None, status=0):
        """On one of the two streams."""
        master, slave = pty.openpty()
        fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("4H", 40, columns, 0, 0))
        streams = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, stream: slave}
        player = subprocess.Popen([KFAST, *arguments], cwd=self.folder, env={**os.environ, **(environment or {})}, **streams)
        os.close(slave)
        written = b""
        while True:
            try:
                written += os.read(master, 65536)
            except OSError:  # the other end is closed
                break
        os.close(master)
        self.assertEqual(player.wait(timeout=120), status)
        return written.decode()

    def compiled(self):
        self.run_kfast("compile", "repeat.kfast")
        return bytearray((self.folder / "repeat.kfb").read_bytes())
