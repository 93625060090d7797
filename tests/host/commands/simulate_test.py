"""The simulated board, and the commands for devices against it."""

import os
import signal
import socket
import subprocess
import time
import unittest
import zlib

from PIL import Image

from command_case import KFAST, CommandTest

# At each frame, and wherever the input stands, another picture.
GAUGE = """kfast 1
canvas 240 240 fps=30 frames=4
input level max=100
object hand fill=red { key 0 { rect 10 10 30 200 }; key 4 { rect 200 10 30 200 } }
object bar fill=blue { rect 0 215 20 20; track x input=level { at 0 0; at 100 200 } }
"""

STILL = """kfast 1
canvas 240 240 fps=30 frames=1
object field fill=lime { rect 60 60 120 120 }
"""

PATIENCE = 120


class Simulated:
    """A running `kfast simulate`."""

    def __init__(self, folder, *arguments, environment=None):
        self.plug = folder / "plug"
        self.told = folder / "told"
        self.errors = folder / "errors"
        with open(self.told, "w") as told, open(self.errors, "w") as errors:
            self.process = subprocess.Popen(
                [KFAST, "simulate", "--socket", self.plug, "--flash-file", folder / "flash", *map(str, arguments)],
                cwd=folder, stdout=told, stderr=errors, env={**os.environ, **(environment or {})})
        self.wait_for(lambda: "listening" in self.told.read_text())

    def wait_for(self, happens):
        end = time.monotonic() + PATIENCE
        while not happens():
            assert self.process.poll() is None, self.errors.read_text()
            assert time.monotonic() < end, self.told.read_text()
            time.sleep(0.02)

    def frames(self):
        """(moment, hash) of each that was shown."""
        lines = self.told.read_text().split("\n")[:-1]
        return [tuple(line.split()[1:]) for line in lines if line.startswith("frame ")]

    def stop(self, number=signal.SIGTERM):
        self.process.send_signal(number)
        return self.process.wait(timeout=PATIENCE)


class SimulateTest(CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "gauge.kfast").write_text(GAUGE)
        (self.folder / "still.kfast").write_text(STILL)

    def simulated(self, *arguments, **more):
        board = Simulated(self.folder, "--headless", "--print-frames", *arguments, **more)
        self.addCleanup(board.process.wait)
        self.addCleanup(board.process.kill)
        return board

    def ask(self, *arguments, **more):
        return self.run_kfast(*arguments, "--device", f"sim:{self.folder / 'plug'}", **more)

    def hashes(self, *arguments):
        """By the number of the frame."""
        lines = self.run_kfast("hash", *arguments).stdout.splitlines()
        return dict(line.split() for line in lines)

    def is_shown(self, board, expected):
        """Waits until all these pictures, {frame: hash}, have been shown, and nothing else since the first."""
        def seen():
            shown = [frame for frame in board.frames() if frame in expected.items()]
            return set(shown) == set(expected.items())
        board.wait_for(seen)

    def test_the_built_in_scene_plays_as_hash_tells(self):
        for panel in ("st7789", "ssd1306", "ssd0323"):
            board = self.simulated("gauge.kfast", "--panel", panel)
            self.is_shown(board, expected := self.hashes("gauge.kfast", "--panel", panel))
            self.assertEqual(set(board.frames()) - set(expected.items()), set())
            self.assertEqual(board.stop(), 0)
            self.assertFalse(board.plug.exists())

    def test_without_a_scene_there_is_a_test_card(self):
        board = self.simulated("--picture", "card.png")
        board.wait_for(lambda: "nothing plays: no scene\n" in board.told.read_text())
        self.assertEqual(board.stop(signal.SIGINT), 0)
        self.assertRegex(board.told.read_text(), r"\ncard\.png: 1 frame, 240x240, \d+ (bytes|KB)\n$")
        with Image.open(self.folder / "card.png") as card:
            self.assertEqual(card.size, (240, 240))
            self.assertGreater(len(card.getcolors(10_000)), 4)

    def test_a_scene_is_sent_and_played(self):
        board = self.simulated("still.kfast")
        self.is_shown(board, self.hashes("still.kfast"))
        self.ask("play", "gauge.kfast")
        self.is_shown(board, self.hashes("gauge.kfast"))
        self.ask("pause")
        self.ask("seek", 2)
        place = len(board.frames())
        board.wait_for(lambda: len(board.frames()) > place + 5)
        self.assertEqual(board.frames()[-1], ("2", self.hashes("gauge.kfast")["2"]))
        self.ask("play", "--built-in")
        self.is_shown(board, self.hashes("still.kfast"))

    def test_inputs_are_driven_live(self):
        board = self.simulated("--panel", "gc9a01")
        live = subprocess.Popen([KFAST, "live", "gauge.kfast", "--device", f"sim:{board.plug}"], cwd=self.folder,
                                stdin=subprocess.PIPE, text=True)
        for level in (0, 37, 100):
            live.stdin.write(f"level {level}\n")
            live.stdin.flush()
            self.is_shown(board, self.hashes("gauge.kfast", "--panel", "gc9a01", "--input", f"level={level}"))
        live.stdin.close()
        self.assertEqual(live.wait(timeout=PATIENCE), 0)

    def test_slots_outlive_the_board(self):
        board = self.simulated("still.kfast")
        self.ask("upload", "gauge.kfast", "--slot", 5, "--choose")
        self.is_shown(board, self.hashes("still.kfast"))
        board.stop()
        board = self.simulated("still.kfast")
        self.is_shown(board, self.hashes("gauge.kfast"))
        self.ask("erase", 5)
        board.stop()
        self.is_shown(self.simulated("still.kfast"), self.hashes("still.kfast"))

    def test_a_configuration_of_a_beam_has_no_display_to_simulate(self):
        self.refuse("simulate", "--headless", "--socket", self.folder / "plug", "--config", "pico-xy-scope",
                    status=1, says="kfast preview --beam")

    def test_the_display_of_a_configuration(self):
        board = self.simulated("gauge.kfast", "--config", "pico-ssd1306", "--picture", "last.png")
        board.wait_for(lambda: len(board.frames()) > 4)
        board.stop()
        with Image.open(self.folder / "last.png") as picture:
            self.assertEqual(picture.size, (128, 64))

    def test_it_is_seen_in_a_window(self):
        board = Simulated(self.folder, "still.kfast", environment={"SDL_VIDEODRIVER": "dummy", "ASAN_OPTIONS": "detect_leaks=0"})
        self.ask("play", "gauge.kfast")
        self.assertEqual(board.errors.read_text(), "")
        self.assertEqual(board.stop(), 0)

    def test_without_a_display_it_runs_all_the_same(self):
        nowhere = {"DISPLAY": "", "WAYLAND_DISPLAY": "", "ASAN_OPTIONS": "detect_leaks=0"}
        board = Simulated(self.folder, environment=nowhere)
        self.assertIn("there is no display for a window", board.errors.read_text())
        self.ask("devices")
        self.assertEqual(board.stop(), 0)

    def test_several_boards(self):
        first = self.simulated("--serial", "LEFT")
        second = subprocess.Popen([KFAST, "simulate", "--headless", "--socket", "right", "--flash-file", "right.bin",
                                   "--serial", "RIGHT"], cwd=self.folder, stdout=subprocess.PIPE, text=True)
        self.addCleanup(second.wait)
        self.addCleanup(second.kill)
        self.addCleanup(second.stdout.close)
        self.assertIn("listening", second.stdout.readline())
        told = self.ask("play", "gauge.kfast", "--device", f"sim:{self.folder / 'right'}").stdout
        self.assertIn("LEFT", told)
        self.assertIn("RIGHT", told)
        self.is_shown(first, self.hashes("gauge.kfast"))

    def test_rubbish_on_the_wire_is_survived(self):
        board = self.simulated("gauge.kfast")
        with socket.socket(socket.AF_UNIX, socket.SOCK_SEQPACKET) as plug:
            plug.connect(str(board.plug))
            rubbish = bytes(zlib.crc32(bytes([place])) & 0xFF for place in range(64))
            for size in (1, 63, 64, 100, 64):
                plug.send((rubbish * 2)[:size])
        self.is_shown(board, self.hashes("gauge.kfast"))
        self.ask("devices")

    def test_what_cannot_be_is_refused(self):
        simulate = ["simulate", "--headless", "--socket", "plug", "--flash-file", "flash"]
        self.refuse(*simulate, "none.kfast", status=1, says="none.kfast")
        self.refuse(*simulate, "--panel", "st7788", status=2, says='did you mean "st7789"')
        self.refuse(*simulate, "--panel", "st7789", "--config", "pico-ssd1306", status=2, says="excludes")
        self.refuse("simulate", "--headless", "--flash-file", "repeat.kfast", "--socket", "plug", status=1,
                    says="is it another file?")
        self.refuse("simulate", "--headless", "--flash-file", "flash", "--socket", "none/plug", status=1,
                    says="cannot listen there")
        for serial in ("", "a b", "\x1b", "x" * 25):
            self.refuse(*simulate, "--serial", serial, status=2, says="is no serial number")
        board = self.simulated()
        self.refuse("simulate", "--headless", "--flash-file", "flash", "--socket", "other", status=1,
                    says="another simulated board uses it")
        self.refuse("simulate", "--headless", "--flash-file", "other", "--socket", "plug", status=1,
                    says="a simulated board runs there already")
        board.stop()


if __name__ == "__main__":
    unittest.main()
