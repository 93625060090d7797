"""kfast preview: what its keys write, and a file that is saved while it plays in a terminal."""

import fcntl
import os
import pathlib
import pty
import re
import select
import shlex
import signal
import struct
import subprocess
import termios
import time
import unittest

from command_case import KFAST, CommandTest

GOOD = '''kfast 1
canvas 40 20 fps=10 frames=10
object lamp fill="#ff0000" { key 0 { rect 0 0 8 8 }; key 5 { rect 30 10 8 8 } }
'''
BAD = GOOD.replace("rect 30", "rectangle 30")


class Preview:
    """A preview in a terminal of its own; if `shell`, begun by one that waits for more once it ends."""

    def __init__(self, folder, *arguments, columns=80, lines=24, environment=None, shell=False):
        self.written = ""
        self.terminal, slave = pty.openpty()
        self.resize(columns, lines)

        def take_terminal():  # as a shell does for a job in the foreground
            os.setsid()
            fcntl.ioctl(slave, termios.TIOCSCTTY, 0)

        plain = {name: value for name, value in os.environ.items() if name not in ("COLORTERM", "NO_COLOR")}
        command = [str(KFAST), "preview", "--terminal", *arguments]
        waiting_shell = ["dash", "-i"]  # which leaves the modes of a terminal to its jobs: bash mends them itself
        self.process = subprocess.Popen(waiting_shell if shell else command, cwd=folder, stdin=slave, stdout=slave,
                                        stderr=slave, preexec_fn=take_terminal,
                                        env={**plain, "TERM": "xterm-256color", **(environment or {})})
        os.close(slave)
        if shell:
            self.type("ulimit -c 0; " + shlex.join(command) + "\n")

    def resize(self, columns, lines):
        fcntl.ioctl(self.terminal, termios.TIOCSWINSZ, struct.pack("HHHH", lines, columns, 0, 0))

    def echoes(self):
        return bool(termios.tcgetattr(self.terminal)[3] & termios.ECHO)

    def type(self, keys):
        os.write(self.terminal, keys.encode())

    def wait_for(self, pattern):
        """What is written from now on until there is `pattern`."""
        seen = ""
        deadline = time.monotonic() + 60
        while not re.search(pattern, seen):
            if time.monotonic() > deadline or not select.select([self.terminal], [], [], 60)[0]:
                raise AssertionError(f"{pattern} is not written, but {seen[-2000:]!r}")
            try:
                seen += os.read(self.terminal, 65536).decode(errors="replace")
            except OSError as closed:
                raise AssertionError(f"it has ended before {pattern}: {seen[-2000:]!r}") from closed
        self.written += seen
        return seen

    def end(self, keys="q"):
        self.type(keys)
        try:
            while block := os.read(self.terminal, 65536):
                self.written += block.decode(errors="replace")
        except OSError:  # the other end is closed
            pass
        os.close(self.terminal)
        return self.process.wait(timeout=60)


class TerminalTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.scene = self.folder / "lamp.kfast"
        self.scene.write_text(GOOD)

    def replace(self, text):
        """As editors do."""
        new = self.folder / ".lamp.kfast.new"
        new.write_text(text)
        os.replace(new, self.scene)

    def test_it_plays_until_somebody_quits_and_shows_its_help_when_asked(self):
        preview = Preview(self.folder, "lamp.kfast")
        first = preview.wait_for(r"(?s)frame 0 .*h: help.*frame 9.*frame 0")
        self.assertNotIn("next key frame", first)
        preview.type("?")
        preview.wait_for("next key frame")
        preview.type("h")
        preview.wait_for(r"(?s)frame 9.*frame 0.*frame 9.*frame 0")
        self.assertEqual(preview.end(), 0)
        self.assertTrue(preview.written.endswith("\x1b[0m\x1b[?25h"))

    def test_ctrl_z_stops_it_with_the_terminal_as_it_was(self):
        shell = Preview(self.folder, "lamp.kfast", shell=True)
        self.addCleanup(shell.process.kill)
        shell.wait_for("h: help")
        shell.type("n")
        shell.wait_for("frame 5 .*paused")
        shell.type("\x1a")
        shell.wait_for(r"(?s)\x1b\[\?25h.*Stopped")
        shell.type("stty -a\n")
        shell.wait_for(r"(?s)[^-]icanon.*[^-]echo ")
        shell.type("fg\n")
        self.assertNotIn("\x1b[2J", shell.wait_for(r"(?s)\x1b\[\?25l.*frame 5 .*paused"))
        shell.type("n")
        shell.wait_for("frame 0 .*paused")
        shell.type("\x1c")  # Ctrl-\
        shell.wait_for(r"(?s)\x1b\[\?25h.*Quit")
        shell.type("stty -a\n")
        shell.wait_for(r"(?s)[^-]icanon.*[^-]echo ")
        self.assertEqual(shell.end("exit 3\n"), 3)

    @staticmethod
    def state(process):
        """A letter: T of one that is stopped, Z of one that its parent has not missed yet, X of none."""
        try:
            return pathlib.Path("/proc", process, "stat").read_text().rpartition(")")[2].split()[0]
        except FileNotFoundError:
            return "X"

    def test_a_signal_ends_it_while_it_is_stopped(self):
        shell = Preview(self.folder, "lamp.kfast", shell=True)
        self.addCleanup(shell.process.kill)
        shell.wait_for("h: help")
        shell.type("\x1a")
        shell.wait_for("Stopped")
        shell.type("jobs -l\n")
        process = re.search(r"\d+(?= Stopped)", shell.wait_for(r"\d+ Stopped"))[0]
        for number in (signal.SIGTERM, signal.SIGCONT):  # as kill of a shell does
            os.kill(int(process), number)
        deadline = time.monotonic() + 60
        while self.state(process) not in ("X", "Z") and time.monotonic() < deadline:
            time.sleep(0.01)
        shell.type("wait %1; echo status $?\n")
        shell.wait_for("status 143")
        self.assertEqual(shell.end("exit 3\n"), 3)

    def test_a_signal_leaves_the_terminal_as_it_was(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            preview = Preview(self.folder, "lamp.kfast")
            self.addCleanup(preview.process.kill)
            preview.wait_for("h: help")
            self.assertFalse(preview.echoes())
            preview.process.send_signal(number)
            preview.wait_for(r"\x1b\[\?25h")
            self.assertEqual(preview.process.wait(timeout=60), -number)
            self.assertTrue(preview.echoes())

    def test_its_help_has_the_keys_that_do_something_there(self):
        preview = Preview(self.folder, "lamp.kfast")
        preview.wait_for("h: help")
        preview.type("h")
        page = preview.wait_for("close this help")
        self.assertNotIn("skeletons", page)
        self.assertIn("read the file afresh", page)
        preview.type("\x1b")
        self.assertNotIn("next key frame", preview.wait_for(r"(?s)frame.*\x1b\[J(.*)\x1b\[J").rsplit("\x1b[J", 2)[1])
        preview.type("kyo")
        self.assertNotIn("bones", preview.wait_for("onion skin"))
        self.assertEqual(preview.end("\x1b"), 0)

    def test_a_help_that_has_no_room_is_turned(self):
        preview = Preview(self.folder, "lamp.kfast", columns=50, lines=12)
        preview.wait_for("frame")
        preview.type("h")
        preview.wait_for("h  next page, 1 of")
        preview.type("h")
        preview.wait_for("h  next page, 2 of")
        self.assertEqual(preview.end(), 0)

    def test_a_mistake_is_shown_below_the_picture_until_it_is_mended(self):
        preview = Preview(self.folder, "lamp.kfast")
        preview.type("n")
        preview.wait_for("frame 5 .*paused")
        self.replace(BAD)
        self.assertIn("\u2580", preview.wait_for("lamp.kfast:3:.*error: .*rectangle"))
        self.replace(GOOD.replace("#ff0000", "#0000ff"))
        self.assertIn("frame 5", preview.wait_for("lamp.kfast is read again"))
        preview.type("s")
        self.assertNotIn("error", preview.wait_for("lamp-0005.png is written"))
        self.assertEqual(preview.end(), 0)
        self.assertTrue((self.folder / "lamp-0005.png").read_bytes().startswith(b"\x89PNG"))

    def test_a_mistake_at_the_start_is_shown_until_it_is_mended(self):
        self.scene.write_text(BAD)
        preview = Preview(self.folder, "lamp.kfast")
        preview.wait_for("lamp.kfast:3:.*error: .*rectangle")
        self.replace(GOOD)
        preview.wait_for(r"(?s)frame 9.*frame 0")
        self.assertEqual(preview.end(), 0)
        self.assertNotIn("error", preview.written.rsplit("frame 9", 1)[1])

    def test_a_mistake_at_the_start_is_refused_where_nobody_can_mend_it(self):
        self.scene.write_text(BAD)
        for arguments in (["--loops", "1"], ["--terminal"], ["--headless"], ["--terminal", "--board", "nothing"]):
            said = self.run_kfast("preview", "lamp.kfast", *arguments, status=1).stderr
            self.assertRegex(said, r"(?s)^lamp.kfast:3:.*rectangle.*kfast: lamp.kfast: 1 error\n$")
        preview = Preview(self.folder, "lamp.kfast", "--board", "nothing")
        preview.wait_for("nothing")
        self.assertEqual(preview.end(""), 1)

    @staticmethod
    def beginning(heard):
        """Of what is heard: the scene as it was when the device was opened."""
        deadline = time.monotonic() + 60
        while heard.stat().st_size < 4096 * 8 and time.monotonic() < deadline:
            time.sleep(0.02)
        return heard.read_bytes()[:4096 * 8]

    def test_the_sound_goes_on_while_the_scene_is_read_again(self):
        heard = self.folder / "heard"  # by SDL's disk driver, which begins a file when a device is opened
        preview = Preview(self.folder, "lamp.kfast", "--audio",
                          environment={"SDL_AUDIODRIVER": "disk", "SDL_DISKAUDIOFILE": str(heard)})
        preview.wait_for("frame")
        mark = heard.stat().st_ino
        begin = self.beginning(heard)
        self.replace(GOOD.replace("rect 0 0 8 8", "rect 20 9 8 8"))
        preview.wait_for("lamp.kfast is read again")
        self.assertEqual(preview.end(), 0)
        self.assertEqual((heard.stat().st_ino, self.beginning(heard)), (mark, begin))

    def test_it_goes_on_in_a_terminal_that_is_resized(self):
        preview = Preview(self.folder, "lamp.kfast")
        preview.wait_for(r"\x1b\[J(?s:.*)\x1b\[J")
        preview.resize(20, 8)
        picture = preview.wait_for(r"(?s)\x1b\[2J\x1b\[H.*frame \d.*\x1b\[J").rsplit("\x1b[2J\x1b[H", 1)[1].split("\x1b[J")[0]
        self.assertLess(picture.count("\n"), 8)
        self.assertLessEqual(max(line.count("\u2580") for line in picture.split("\n")), 20)
        self.assertEqual(preview.end("\x1b"), 0)

    def test_without_a_display_only_kfast_says_so(self):
        displays = ("DISPLAY", "WAYLAND_DISPLAY", "XDG_RUNTIME_DIR", "SDL_VIDEODRIVER")
        environment = {name: value for name, value in os.environ.items() if name not in displays}
        said = subprocess.run([str(KFAST), "preview", "lamp.kfast", "--loops", "1"], cwd=self.folder, env=environment,
                              stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, check=True)
        self.assertRegex(said.stderr, r"^kfast: [^\n]*, so this plays in the terminal\n$")

    def test_the_editor_has_the_terminal_and_gives_it_back(self):
        editor = self.folder / "editor"
        editor.write_text('#!/bin/sh\necho "edits $*"; stty -a | grep -o " [-]*icanon"; read answer\n'
                          'sed -i s/ff0000/0000ff/ lamp.kfast; echo "done $answer"\n')
        editor.chmod(0o755)
        preview = Preview(self.folder, "lamp.kfast", environment={"KFAST_EDITOR": f"{editor} +{{line}} {{file}}", "VISUAL": "none"})
        preview.wait_for("h: help")
        preview.type("n\t")
        preview.wait_for("frame 5 .*paused.*selected lamp")
        preview.type("\r")
        preview.wait_for(r"(?s)edits \+3 /.*/lamp.kfast.* icanon")
        self.assertTrue(preview.echoes())
        preview.type("well\n")
        preview.wait_for(r"(?s)done well.*\x1b\[\?25l.*frame 5 .*lamp.kfast is read again")
        self.assertFalse(preview.echoes())
        self.assertEqual(preview.end(), 0)

    def test_without_an_editor_the_remedy_is_told(self):
        preview = Preview(self.folder, "lamp.kfast", environment={"KFAST_EDITOR": "", "VISUAL": "", "EDITOR": ""})
        preview.type("\r")
        preview.wait_for("no editor is set: set KFAST_EDITOR, VISUAL or EDITOR, as in EDITOR=nano")
        self.assertEqual(preview.end(), 0)
        preview = Preview(self.folder, "lamp.kfast", environment={"KFAST_EDITOR": "no-such-editor"})
        preview.type("\r")
        preview.wait_for('the editor "no-such-editor" is not there')
        self.assertEqual(preview.end(), 0)

    def test_it_plays_as_slowly_as_a_board(self):
        preview = Preview(self.folder, "lamp.kfast", "--board-speed")
        preview.wait_for("as on pico: 10 fps")
        preview.type("w")
        preview.wait_for(r"frame \d  \d.\d+ s  playing  +h: help")
        self.assertEqual(preview.end(), 0)

    def test_colours_are_those_of_the_terminal(self):
        for environment, colour in (({"COLORTERM": "truecolor"}, r"\x1b\[38;2;255;0;0m"), ({}, r"\x1b\[38;5;196m"),
                                    ({"TERM": "linux"}, r"\x1b\[91m"), ({"NO_COLOR": "1"}, "--------")):
            preview = Preview(self.folder, "lamp.kfast", environment=environment)
            preview.type("p")
            preview.wait_for(colour)
            self.assertEqual(preview.end(), 0)

    def test_many_keys_at_once_are_all_taken(self):
        preview = Preview(self.folder, "lamp.kfast")
        preview.wait_for("frame")
        preview.type("n" + "\x1b[C" * 60 + "\t\x1b[Zv" + "ok" * 20)
        preview.wait_for("frame 5 .*speed -1")
        self.assertEqual(preview.end(), 0)

    def test_a_dumb_terminal_gets_one_picture(self):
        preview = Preview(self.folder, "lamp.kfast", environment={"TERM": "dumb"})
        self.assertEqual(preview.end(""), 0)
        self.assertNotIn("\x1b", preview.written)
        self.assertIn("--------", preview.written)


class ScriptTest(CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "lamp.kfast").write_text(GOOD)
        (self.folder / "other.kfast").write_text("kfast 1\ncanvas 4 4\n")

    def keys(self, keys, *arguments):
        return self.run_kfast("preview", "lamp.kfast", "--headless", "--press", keys, *arguments).stdout

    def test_every_key_works_without_a_display(self):
        listed = self.run_kfast("preview", "--help").stdout
        names = re.findall(r"(?m)^  (\S+) +[a-z]", listed.split("Keys of the window")[1])
        self.assertGreater(len(names), 25)
        names = [name for name in names if name not in ("q", "escape")]
        self.assertEqual(len(re.findall("(?m)^frame ", self.keys(" ".join(names)))), len(names))
        self.assertTrue((self.folder / "lamp.gif").exists())

    def test_a_snapshot_is_the_window_after_the_keys(self):
        sizes = []
        for keys, size in (("tab", "320x240"), ("tab e", "900x600")):
            written = self.keys(keys, "--snapshot", "window.png", "--window", size).splitlines()[-1]
            self.assertRegex(written, rf"^window\.png: the window, {size}, \d+ KB$")
            head = (self.folder / "window.png").read_bytes()[:24]
            self.assertEqual(head[:8], b"\x89PNG\r\n\x1a\n")
            sizes.append(struct.unpack(">II", head[16:]))
        self.assertEqual(sizes, [(320, 240), (900, 600)])
        self.refuse("preview", "lamp.kfast", "--snapshot", "window.png", status=2, says="--headless")
        self.refuse("preview", "lamp.kfast", "--headless", "--snapshot", "w.png", "--window", "big", status=2, says="--window")
        self.refuse("preview", "lamp.kfast", "--headless", "--snapshot", "no/w.png", status=1, says="no/w.png")

    def test_what_keys_turn_on_is_told(self):
        self.assertIn("  selected lamp  onion skin  no time line  zoom 2  ", self.keys("tab o y z z"))

    def test_another_file_is_opened_and_a_wrong_one_is_not(self):
        out = self.keys("open=other.kfast open=nowhere.kfast open=.")
        self.assertIn("error: nowhere.kfast: there is no such file", out)
        self.assertIn("error: .: this is a folder", out)
        self.assertEqual(len(set(re.findall("[0-9a-f]{8}$", out, re.M))), 2)

    def test_options_about_the_first_file_are_left_out_where_they_do_not_suit(self):
        (self.folder / "clips.kfast").write_text(GOOD + "clip blink from=2 to=4\n")
        out = self.run_kfast("preview", "clips.kfast", "--clip", "blink", "--headless", "--press", "right open=lamp.kfast").stdout
        self.assertIn("clip blink", out)
        self.assertIn("notice: --clip: there is no clip 'blink'", out)
        self.assertIn("so that is left out", out)

    def test_wrong_boards_and_objects_are_refused(self):
        self.refuse("preview", "lamp.kfast", "--headless", "--press", "e", "--board", "nothing", status=1, says="nothing")
        self.refuse("preview", "lamp.kfast", "--headless", "--press", "select=lump", status=1, says="did you mean")
        self.refuse("preview", "lamp.kfast", "--headless", "--press", "frame=x", status=2, says="is no key")


if __name__ == "__main__":
    unittest.main()
