"""kfast-first-look shows what `kfast preview --terminal` does, and ends as it was asked to."""

import os
import pty
import re
import select
import signal
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
    else:
        os.kill(child, signal.SIGKILL)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), written.decode()


def changed_state(child, terminal):
    """The status of wait() once the child is stopped or ends, while what it draws is read."""
    deadline = time.monotonic() + 30
    while time.monotonic() < deadline:
        if select.select([terminal], [], [], 0.05)[0]:
            os.read(terminal, 65536)
        process, status = os.waitpid(child.pid, os.WNOHANG | os.WUNTRACED)
        if process == child.pid:
            return status
    raise AssertionError("it goes on")


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

    def test_it_stops_and_goes_on_as_a_shell_asks(self):
        terminal, its_side = pty.openpty()
        self.addCleanup(os.close, terminal)
        self.addCleanup(os.close, its_side)
        child = subprocess.Popen([FIRST_LOOK, SCENE, "1000000"], stdin=subprocess.DEVNULL, stdout=its_side, process_group=0,
                                 env={**os.environ, "TERM": "xterm-256color"})
        self.addCleanup(child.wait)
        self.addCleanup(child.kill)
        self.assertTrue(os.read(terminal, 65536))  # it has taken the terminal
        child.send_signal(signal.SIGTSTP)
        self.assertTrue(os.WIFSTOPPED(changed_state(child, terminal)))
        child.send_signal(signal.SIGCONT)
        child.send_signal(signal.SIGTERM)
        self.assertEqual(-signal.SIGTERM, os.waitstatus_to_exitcode(changed_state(child, terminal)))

    def test_mistakes_are_named(self):
        for arguments, status, words in [((SCENE,), 2, "usage"), ((SCENE, "0"), 2, "usage"), ((SCENE, "1x"), 2, "usage"),
                                         ((SCENE + ".missing", "1"), 1, ".missing"), ((__file__, "1"), 1, "error")]:
            with self.subTest(arguments):
                shown = piped(FIRST_LOOK, *arguments)
                self.assertEqual(shown.returncode, status)
                self.assertIn(words, shown.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
