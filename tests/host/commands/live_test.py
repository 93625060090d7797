"""Live values from standard input, through the real command and boards behind sockets."""

import re
import signal
import subprocess
import textwrap
import time
import unittest

from command_case import KFAST, ROOT
from device_case import INPUTS, INTERRUPTED, PAUSE, PLAY, SILENCE, UNPLUGGED, DeviceTest

START, RAM = 4, 2


def values_of(report):
    """{input: place} of a report that sets inputs."""
    return {report[3 + 5 * at]: int.from_bytes(report[4 + 5 * at:8 + 5 * at], "little") for at in range(report[2])}


class LiveTest(DeviceTest):
    def live(self, text, *arguments, status=0):
        result = subprocess.run([KFAST, "live", *map(str, arguments), *self.device], cwd=self.folder, input=text,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, timeout=120)
        self.assertEqual(result.returncode, status, result.stderr)
        return result

    def sent(self, board):
        """What inputs were set to, report by report; those without any are left out."""
        return [values_of(report) for report in board.reports(INPUTS) if report[2] != 0]

    def wait_for(self, is_so):
        deadline = time.monotonic() + 60
        while not is_so():
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.02)

    def test_a_pose_goes_in_one_report_without_an_answer(self):
        board = self.board()
        self.live('# a pose\n\ngaze -1 "left lid" 50\n', "knobs.kfast")
        self.assertEqual(self.sent(board), [{0: 0, 1: 32768}])
        self.assertTrue(all(report[1] == 0 for report in board.reports(INPUTS)))
        self.assertEqual([report[2] for report in board.reports(PLAY)], [RAM])
        self.assertEqual(board.reports(SILENCE, PAUSE), [])

    def test_a_drawing_goes_in_as_many_reports_as_it_needs(self):
        (self.folder / "plot.kfast").write_text(
            "kfast 1\ncanvas 64 64\ninput n\ninput plot kind=drawing points=40 strokes=2\n"
            "object o stroke=lime live=plot { track x input=n { at 0 0; at 1 9 } }\n")
        board = self.board()
        points = " ".join(f"{at},{at / 2}" for at in range(15))
        self.live(f"n 1\nplot {points} / 60,-3\nplot\n", "plot.kfast", "--rate", 5)
        full, *last = board.reports(0x38, 0x39)
        self.assertEqual((full[0], full[2:4]), (0x38, bytes([1, 0])))
        self.assertEqual(full[4:], b"".join((16 * at).to_bytes(2, "little") + (8 * at).to_bytes(2, "little") for at in range(15)))
        self.assertEqual(last[0][:6], bytes([0x39, 0, 1, 1, 17, 0]))
        self.assertEqual(last[0][6:14], bytes([0, 0x80, 0, 0]) + (960).to_bytes(2, "little") + (0x10000 - 48).to_bytes(2, "little"))
        self.assertEqual(last[1][:6], bytes([0x39, 0, 33, 0, 0, 0]))
        self.assertEqual(len(last), 2)
        self.live("plot 1,1\n")
        self.assertIn("line 1: \"1\" is no point", self.live("plot 1\n", status=1).stderr)

    def test_without_a_scene_the_device_is_asked_for_its_inputs(self):
        board = self.board()
        self.ask("play", "knobs.kfast")
        self.live("gaze 1\n")
        self.assertEqual(self.sent(board), [{0: 65536}])
        self.live("gase 1\n", status=1)

    def test_the_last_line_needs_no_end(self):
        board = self.board()
        self.live("gaze 1", "knobs.kfast")
        self.assertEqual(self.sent(board), [{0: 65536}])

    def test_the_newest_value_wins_when_the_device_is_behind(self):
        board = self.board("A", "--microseconds", 20_000)
        lines = [f"gaze {number / 1000}\n" for number in range(-1000, 1001)]
        self.live("".join(lines), "knobs.kfast")
        sent = self.sent(board)
        self.assertLess(len(sent), 500)
        self.assertEqual(sent[-1], {0: 65536})

    def test_each_line_is_sent_at_a_rate(self):
        board = self.board()
        lines = [f"gaze {number / 100}\n" for number in range(100)]
        begin = time.monotonic()
        self.live("".join(lines), "knobs.kfast", "--rate", 50)
        self.assertGreaterEqual(time.monotonic() - begin, 99 / 50)
        self.assertEqual(self.sent(board)[-1], {0: 65208})
        self.assertGreater(len(self.sent(board)), 20)

    def test_values_are_sent_as_they_come(self):
        board = self.board()
        process = self.start("live", "knobs.kfast")
        for number in range(1, 6):
            process.stdin.write(f"gaze {number / 10}\n")
            process.stdin.flush()
            self.wait_for(lambda: len(self.sent(board)) == number)
        process.stdin.close()
        self.assertEqual(process.wait(60), 0)

    def test_several_devices(self):
        boards = [self.board(name) for name in "AB"]
        self.live("gaze 1\n", "knobs.kfast")
        self.assertEqual([self.sent(board) for board in boards], [[{0: 65536}]] * 2)

    def test_what_the_document_shows(self):
        document = (ROOT / "docs/devices.md").read_text()
        (self.folder / "shown.kfast").write_text(re.search(r"(?s)```kdl\n(.*?)```", document)[1])
        lines = textwrap.dedent(re.search(r"(?m)^    # a comment\n(?:    .*\n)+", document)[0])
        board = self.board()
        self.live(lines, "shown.kfast", "--rate", 20)
        self.assertEqual(self.sent(board), [{0: 49152}, {0: 24576, 1: 26214}])

    def test_what_happens_at_the_end(self):
        for words, kinds in ((("hold",), [PLAY, SILENCE, PAUSE, SILENCE]), (("return",), [PLAY, SILENCE, PLAY, SILENCE]),
                             (("go-on",), [PLAY])):
            with self.subTest(words):
                self.device = ()
                board = self.board("end-" + words[0])
                self.live("gaze 1\n", "knobs.kfast", "--on-silence", *words, "--silence", "2.5")
                self.assertEqual([report[0] for report in board.reports(PLAY, SILENCE, PAUSE)], kinds)
                if words[0] != "go-on":
                    armed, disarmed = board.reports(SILENCE)
                    self.assertEqual(int.from_bytes(armed[2:4], "little"), 2500)
                    self.assertEqual(armed[4], words[0] == "return")
                    self.assertEqual(disarmed[2:4], b"\0\0")
                if words[0] == "return":
                    self.assertEqual(board.reports(PLAY)[-1][2], START)

    def test_a_quiet_input_is_no_silence(self):
        board = self.board()
        process = self.start("live", "knobs.kfast", "--on-silence", "return", "--silence", "0.3")
        self.wait_for(lambda: len(board.reports(INPUTS)) > 8)
        self.assertEqual(self.sent(board), [])
        process.stdin.close()
        self.assertEqual(process.wait(60), 0)

    def test_a_computer_that_is_gone_is_noticed(self):
        self.board()
        process = self.start("live", "knobs.kfast", "--on-silence", "return")
        process.stdin.write("gaze 1\n")
        process.stdin.flush()
        time.sleep(0.5)
        process.kill()
        self.wait_for(lambda: self.told("devices")[0]["playing"]["home"] == "built-in")

    def test_an_interruption_leaves_the_device_as_asked(self):
        for words, last in ((["--on-silence", "return"], "built-in"), ([], "RAM")):
            with self.subTest(words):
                self.device = ()
                board = self.board("A" if words else "B")
                process = self.start("live", "knobs.kfast", *words)
                process.stdin.write("gaze 1\n")
                process.stdin.flush()
                self.wait_for(lambda: self.sent(board))
                process.send_signal(signal.SIGINT)
                self.assertEqual(process.wait(60), INTERRUPTED)
                self.assertEqual(process.stderr.read(), "kfast: interrupted\n")
                self.assertEqual(self.told("devices")[0]["playing"]["home"], last)

    def test_mistakes_name_their_line(self):
        self.board()
        for text, says in (("gaze 0\n\ngase 1\n", "line 3: there is no input 'gase': did you mean \"gaze\"?"),
                           ("gaze 2\n", "line 1: '2' is no value of gaze: it goes from -1 to 1"),
                           ("gaze\n", "line 1: 'gaze' has no value"), ("gaze 1 x", "line 1: there is no input 'x'")):
            self.assertIn(says, self.live(text, "knobs.kfast", "--on-silence", "return", status=1).stderr)
        self.assertEqual(self.told("devices")[0]["playing"]["home"], "built-in", "it has returned all the same")

    def test_wrong_uses(self):
        self.board()
        self.assertIn("no inputs", self.live("", "once.kfast", status=1).stderr)
        self.live("", "knobs.kfast", "--on-silence", "explode", status=2)
        self.live("", "knobs.kfast", "--rate", "0", status=2)
        self.live("", "knobs.kfast", "--silence", "100", status=2)
        for option in ("--rate", "--silence"):
            self.live("", "knobs.kfast", option, "nan", status=2)

    def test_a_closed_input_is_no_input(self):
        self.board()
        closed = subprocess.run(f"exec '{KFAST}' live knobs.kfast {' '.join(map(str, self.device))} <&-", shell=True,
                                cwd=self.folder, stderr=subprocess.PIPE, text=True, timeout=120)
        self.assertEqual(closed.returncode, 1)
        self.assertIn("standard input is closed", closed.stderr)

    def test_unplugged(self):
        board = self.board("A", "--unplugged-after", 40)
        process = self.start("live", "knobs.kfast")
        for number in range(1000):
            try:
                process.stdin.write(f"gaze {number / 1000}\n")
                process.stdin.flush()
            except BrokenPipeError:
                break
            if process.poll() is not None:
                break
            time.sleep(0.005)
        self.assertEqual(process.wait(60), UNPLUGGED)
        self.assertIn("A: the device is gone", process.stderr.read())
        self.assertLessEqual(len(board.lines()), 40)


if __name__ == "__main__":
    unittest.main()
