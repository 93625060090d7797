"""kfast-first-look shows what `kfast preview --terminal` does, and ends as it was asked to."""

import os
import pty
import re
import select
import subprocess
import sys
import time
import unittest

FIRST_LOOK, KFAST, SCENE = sys.argv[1:4]


def piped(*command):
    return subprocess.run(command, capture_output=True, text=True, timeout=120)


def in_terminal(*arguments, keys=""):
    """Exit status and all that is written to a terminal of its own."""
    child, terminal = pty.fork()
    if child == 0:
        os.environ["TERM"] = "xterm-256color"
        os.execv(FIRST_LOOK, [FIRST_LOOK, *arguments])
    if keys:
        os.write(terminal, keys.encode())
    written = b""
    deadline = time.monotonic() + 60
    while time.monotonic() < deadline:
        if not select.select([terminal], [], [], 1)[0]:
            continue
        try:
            written += os.read(terminal, 65536)
        except OSError:  # its other end is closed
            break
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), written.decode()


class FirstLookTest(unittest.TestCase):
    def test_a_pipe_gets_the_first_picture_of_the_preview(self):
        shown = piped(FIRST_LOOK, SCENE, "3")
        self.assertEqual(shown.returncode, 0)
        self.assertGreater(len(shown.stdout), 1000)
        self.assertEqual(shown.stdout, piped(KFAST, "preview", "--terminal", SCENE).stdout)

    def test_a_terminal_shows_pictures_above_each_other_and_has_its_cursor_back(self):
        status, written = in_terminal(SCENE, "1")
        self.assertEqual(status, 0)
        self.assertTrue(written.rstrip().endswith("\x1b[?25h"))
        pictures = re.split(r"\x1b\[\d+A", written)
        self.assertGreater(len(set(pictures)), 3)

    def test_q_ends_it(self):
        self.assertEqual(in_terminal(SCENE, "1000000", keys="q")[0], 0)

    def test_mistakes_are_named(self):
        for arguments, status, words in [((SCENE,), 2, "usage"), ((SCENE, "0"), 2, "usage"), ((SCENE, "1x"), 2, "usage"),
                                         ((SCENE + ".missing", "1"), 1, ".missing"), ((__file__, "1"), 1, "error")]:
            with self.subTest(arguments):
                shown = piped(FIRST_LOOK, *arguments)
                self.assertEqual(shown.returncode, status)
                self.assertIn(words, shown.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
