"""Everything that draws, through the real command."""

import fcntl
import os
import pty
import re
import signal
import struct
import subprocess
import termios
import time
import unittest
import zlib

from PIL import Image

from command_case import KFAST, CommandTest, kfast


class HashTest(CommandTest):
    def hashes(self, *arguments):
        return self.run_kfast("hash", *arguments).stdout.splitlines()

    def test_one_line_per_frame(self):
        for loop, count in (("repeat", 10), ("once", 11), ("ping-pong", 10)):
            lines = self.hashes(f"{loop}.kfast")
            self.assertEqual([int(line.split()[0]) for line in lines], list(range(count)))
            self.assertTrue(all(re.fullmatch(r"\d+ [0-9a-f]{8}", line) for line in lines))

    def test_the_hash_is_the_crc32_of_the_pixels(self):
        (self.folder / "empty.kfast").write_text('kfast 1\ncanvas 3 2 background="#ffffff"\n')
        for form, pixels in (("rgb565", b"\xff" * 12), ("grey4", b"\xff\xf0" * 2), ("mono1", b"\xe0" * 2)):
            self.assertEqual(self.hashes("empty.kfast", "--format", form)[0], f"0 {zlib.crc32(pixels):08x}")

    def test_a_panel_on_a_simulated_board_shows_what_the_core_draws(self):
        for loop in ("repeat", "once", "ping-pong"):
            drawn = self.hashes(f"{loop}.kfast", "--size", "128x64", "--format", "grey4")
            self.assertEqual(self.hashes(f"{loop}.kfast", "--panel", "ssd0323"), drawn)

    def test_a_simulated_board_refuses_what_it_cannot_keep(self):
        (self.folder / "long.kfast").write_text(
            "kfast 1\ncanvas 8 8 frames=10001\nobject a fill=white { rect 1 1 2 2 }\n")
        self.refuse("hash", "long.kfast", "--panel", "ssd0323", status=1, says="at most 10000")

    def test_size_and_fit_change_the_picture(self):
        sizes = [self.hashes("repeat.kfast", "--size", "64x64", "--fit", fit)[1] for fit in ("contain", "cover", "none")]
        self.assertEqual(len(set(sizes)), 3)

    def test_a_full_output_is_a_failure(self):
        with open("/dev/full", "w", encoding="utf-8") as full:
            result = subprocess.run([KFAST, "hash", self.folder / "repeat.kfast"], stdout=full, stderr=subprocess.PIPE)
        self.assertEqual(result.returncode, 1)
        self.assertIn(b"standard output", result.stderr)


class RenderTest(CommandTest):
    def picture(self, *arguments):
        self.run_kfast("render", *arguments, "-o", "out.png")
        with Image.open(self.folder / "out.png") as image:
            return image.size, image.convert("RGB").tobytes()

    def test_a_frame_is_its_time(self):
        size, frame = self.picture("repeat.kfast", "--frame", "3")
        self.assertEqual(size, (60, 40))
        for moment in ("3", "3.0", "0.1s", "100ms", "13"):
            self.assertEqual(self.picture("repeat.kfast", "--time", moment), (size, frame), moment)
        self.assertNotEqual(self.picture("repeat.kfast", "--time", "3.5"), (size, frame))

    def test_pixels(self):
        size, pixels = self.picture("repeat.kfast", "--frame", "0", "--format", "mono1")
        lit = [i for i in range(len(pixels) // 3) if pixels[3 * i] == 255]
        self.assertEqual(lit, [60 * y + x for y in range(1, 15) for x in range(1, 15)])

    def test_all_as_a_folder(self):
        self.run_kfast("render", "once.kfast", "--all", "-o", "new/frames")
        names = sorted(path.name for path in (self.folder / "new/frames").iterdir())
        self.assertEqual(names, [f"{i:04}.png" for i in range(11)])

    def test_all_as_a_gif(self):
        for loop, count, repeats in (("repeat", 10, 0), ("once", 11, None), ("ping-pong", 20, 0)):
            self.run_kfast("render", f"{loop}.kfast", "--all", "-o", "out.gif")
            with Image.open(self.folder / "out.gif") as gif:
                self.assertEqual((gif.n_frames, gif.info.get("loop")), (count, repeats))
                durations = []
                for index in range(count):
                    gif.seek(index)
                    durations.append(gif.info["duration"])
            self.assertEqual(durations[:6], [30, 30, 40, 30, 30, 40])

    def test_a_gif_shows_the_frames(self):
        self.run_kfast("render", "repeat.kfast", "--all", "-o", "out.gif")
        with Image.open(self.folder / "out.gif") as gif:
            gif.seek(7)
            shown = gif.convert("RGB").tobytes()
        self.assertEqual(shown, self.picture("repeat.kfast", "--frame", "7")[1])

    def test_wrong_usage(self):
        render = ["render", "repeat.kfast"]
        self.refuse(*render, "--frame", "1", status=2, says="--output is required")
        self.refuse(*render, "-o", "a.png", status=2, says="--frame")
        self.refuse(*render, "-o", "a.png", "--frame", "1", "--all", status=2, says="--frame")
        self.refuse(*render, "-o", "a.png", "--frame", "10", status=2, says="it has frames 0 to 9")
        self.refuse(*render, "-o", "a.png", "--frame", "-1", status=2, says="it has frames 0 to 9")
        self.refuse(*render, "-o", "a.png", "--time", "1h", status=2, says="'1h' is no time")
        self.refuse(*render, "-o", "a.png", "--all", status=2, says="makes a folder or a .gif")
        self.refuse(*render, "-o", "a.gif", "--frame", "1", status=2, says="add --all for a .gif")

    def test_never_overwrites_its_input(self):
        for name in ("repeat.kfast", "./repeat.kfast"):
            self.refuse("render", "repeat.kfast", "--frame", "1", "-o", name, status=1, says="overwrite the scene")
        os.rename(self.folder / "repeat.kfast", self.folder / "text.gif")
        self.refuse("render", "text.gif", "--all", "-o", "text.gif", status=1, says="overwrite the scene itself")
        self.assertTrue((self.folder / "text.gif").read_text().startswith("kfast 1"))

    def test_unwritable_outputs(self):
        (self.folder / "file").write_text("")
        self.refuse("render", "repeat.kfast", "--all", "-o", "file", status=1, says="cannot make the folder file")
        self.refuse("render", "repeat.kfast", "--all", "-o", "none/a.gif", status=1, says="create the folder first")
        self.refuse("render", "repeat.kfast", "--all", "-o", "a.gif", status=1, says="make room", limit=64)
        self.refuse("render", "repeat.kfast", "--frame", "1", "-o", "a.png", status=1, says="make room", limit=64)


class PreviewTest(CommandTest):
    def test_headless_shows_every_frame(self):
        for loop, count in (("repeat", 10), ("once", 11)):
            line = self.run_kfast("preview", f"{loop}.kfast", "--headless").stdout
            self.assertRegex(line, rf"^{count} frames, hash [0-9a-f]{{8}}\n$")

    def test_keys(self):
        out = self.run_kfast("preview", "repeat.kfast", "--headless", "--keys", "n n p space right").stdout
        shown = [int(line.split()[1]) for line in out.splitlines()[:-1]]
        self.assertEqual(shown, [4, 0, 4, 4, 6])
        hashes = [line.split()[1] for line in self.run_kfast("hash", "repeat.kfast").stdout.splitlines()]
        self.assertEqual([line.split()[-1] for line in out.splitlines()[:-1]], [hashes[i] for i in shown])

    def test_terminal_in_a_pipe_is_one_picture(self):
        out = self.run_kfast("preview", "repeat.kfast", "--terminal", environment={"COLORTERM": "truecolor"}).stdout
        self.assertEqual(out.count("\n"), 20)
        self.assertEqual(out.count("\u2580"), 60 * 20)
        self.assertIn("38;2;", out)
        out = self.run_kfast("preview", "repeat.kfast", "--terminal", environment={"COLORTERM": ""}).stdout
        self.assertIn("38;5;", out)

    def on_a_terminal(self, *arguments, interrupt):
        """What is written to a terminal of 40 x 12 characters, and how the program ends."""
        master, slave = pty.openpty()
        fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 12, 40, 0, 0))
        player = subprocess.Popen([KFAST, "preview", "--terminal", *arguments], cwd=self.folder, stdout=slave)
        os.close(slave)
        written = b""
        while True:
            try:
                block = os.read(master, 65536)
            except OSError:  # the other end is closed
                break
            written += block
            if interrupt and b"frame 2" in written:
                player.send_signal(signal.SIGINT)
        os.close(master)
        return written.decode(), player.wait(timeout=60)

    def test_a_terminal_plays_one_loop_and_gets_its_cursor_back(self):
        for loop, last in (("repeat", 9), ("once", 10)):
            written, status = self.on_a_terminal(f"{loop}.kfast", interrupt=False)
            self.assertEqual(status, 0)
            self.assertTrue(written.startswith("\x1b[?25l") and written.endswith("\x1b[0m\x1b[?25h"))
            frames = [int(number) for number in re.findall(r"frame (\d+)", written)]
            self.assertEqual((frames, frames[0], frames[-1]), (sorted(frames), 0, last))
            self.assertLessEqual(max(picture.count("\n") for picture in written.split("\x1b[J")), 12)

    def test_control_c_gives_the_cursor_back(self):
        written, status = self.on_a_terminal("repeat.kfast", "--loops", "1000", interrupt=True)
        self.assertEqual(status, -signal.SIGINT)
        self.assertTrue(written.endswith("\x1b[0m\x1b[?25h"))

    def test_no_display_falls_back_to_the_terminal(self):
        nowhere = {"DISPLAY": "", "WAYLAND_DISPLAY": "", "ASAN_OPTIONS": "detect_leaks=0"}
        result = self.run_kfast("preview", "repeat.kfast", environment=nowhere)
        self.assertIn("there is no display", result.stderr)
        self.assertIn("\u2580", result.stdout)

    def test_a_window_ends_when_it_is_told_to(self):
        unseen = {**os.environ, "SDL_VIDEODRIVER": "dummy", "ASAN_OPTIONS": "detect_leaks=0"}
        window = subprocess.Popen([KFAST, "preview", self.folder / "repeat.kfast"], env=unseen)
        time.sleep(2)
        self.assertIsNone(window.poll(), "it plays until it is closed")
        window.send_signal(signal.SIGINT)
        self.assertEqual(window.wait(timeout=60), 0)

    def test_a_window_closes_after_its_loops(self):
        unseen = {"SDL_VIDEODRIVER": "dummy", "ASAN_OPTIONS": "detect_leaks=0"}
        begun = time.monotonic()
        self.run_kfast("preview", "repeat.kfast", "--loops", "3", environment=unseen)
        self.assertGreaterEqual(time.monotonic() - begun, 1, "three times ten frames of 1/30 s")

    def test_wrong_usage(self):
        preview = ["preview", "repeat.kfast"]
        self.refuse(*preview, "--keys", "n", status=2, says="--keys requires --headless")
        self.refuse(*preview, "--headless", "--keys", "n x", status=2, says="'x' is no key")
        self.refuse(*preview, "--headless", "--terminal", status=2, says="excludes")
        self.refuse(*preview, "--terminal", "--loops", "0", status=2, says="--loops")
        self.refuse(*preview, "--headless", "--loops", "2", status=2, says="excludes")


if __name__ == "__main__":
    unittest.main()
