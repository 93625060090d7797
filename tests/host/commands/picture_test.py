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

from command_case import KFAST, ROOT, CommandTest

# Examples with bones, backbones, turns in space and key times; all of them repeat.
MOVING = ("stroller.kfast", "worm.kfast", "card.kfast", "ball.kfast")


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
        for form, pixels in (("rgb565", b"\xff" * 12), ("rgb565_be", b"\xff" * 12),
                             ("rgb444", b"\xff\xff\xff\xff\xf0" * 2), ("rgb666", b"\xfc" * 18),
                             ("grey4", b"\xff\xf0" * 2), ("mono1", b"\xe0" * 2), ("mono1_dithered", b"\xe0" * 2)):
            self.assertEqual(self.hashes("empty.kfast", "--format", form)[0], f"0 {zlib.crc32(pixels):08x}")

    def test_dither_shows_greys_in_one_bit(self):
        (self.folder / "grey.kfast").write_text('kfast 1\ncanvas 8 8 background="#808080"\n')
        for form, pixels in (("mono1", b"\xff" * 8), ("mono1_dithered", b"\xaa\x55" * 4)):
            self.assertEqual(self.hashes("grey.kfast", "--format", form)[0], f"0 {zlib.crc32(pixels):08x}")

    def test_a_panel_on_a_simulated_board_shows_what_the_core_draws(self):
        for loop in ("repeat", "once", "ping-pong"):
            drawn = self.hashes(f"{loop}.kfast", "--size", "128x64", "--format", "grey4")
            self.assertEqual(self.hashes(f"{loop}.kfast", "--panel", "ssd0323"), drawn)

    def moments(self, *arguments):
        """The frames of the whole scene that the hashes of a clip are found at."""
        known = [line.split()[1] for line in self.hashes("marked.kfast", "--speed", "0.5")]
        end = self.hashes("marked.kfast", "--clip", "sway", "--speed", "-1")[0].split()[1]
        return [(known + [end]).index(line.split()[1]) / 2 for line in self.hashes("marked.kfast", *arguments)]

    def test_a_clip_has_its_own_frames_and_its_own_loop(self):
        self.assertEqual(self.moments("--clip", "blink"), [2, 3, 4, 5, 6])
        self.assertEqual(self.moments("--clip", "sway"), [4, 5, 6, 7, 8, 9])

    def test_a_speed_changes_the_frames(self):
        self.assertEqual(self.moments("--speed", "3"), [0, 3, 6, 9])
        self.assertEqual(self.moments("--speed", "-2"), [0, 8, 6, 4, 2])
        self.assertEqual(self.moments("--clip", "blink", "--speed", "0.5"), [2, 2.5, 3, 3.5, 4, 4.5, 5, 5.5, 6])
        self.assertEqual(self.moments("--clip", "blink", "--speed", "-1"), [6, 5, 4, 3, 2])
        self.assertEqual(self.moments("--clip", "sway", "--speed", "-1"), [10, 9, 8, 7, 6, 5])

    def test_a_panel_plays_clips_at_any_speed(self):
        for arguments in (("--clip", "blink", "--speed", "0.5"), ("--clip", "sway", "--speed", "-1")):
            drawn = self.hashes("marked.kfast", *arguments, "--size", "128x64", "--format", "grey4")
            self.assertEqual(self.hashes("marked.kfast", *arguments, "--panel", "ssd0323"), drawn)

    def test_backwards_is_the_same_pictures(self):
        for name in MOVING:
            forwards = self.hashes(ROOT / "examples" / name)
            backwards = [line.split()[1] for line in self.hashes(ROOT / "examples" / name, "--speed", "-1")]
            shown = [line.split()[1] for line in forwards]
            self.assertEqual(backwards, [shown[-index] for index in range(len(shown))], name)

    def test_wrong_clips_and_speeds(self):
        for command in (["hash"], ["render", "--all", "-o", "a.gif"], ["preview", "--headless"]):
            self.refuse(*command, "marked.kfast", "--clip", "blnk", status=2, says='did you mean "blink"?')
            self.refuse(*command, "marked.kfast", "--clip", "", status=2, says="there is no clip ''")
            self.refuse(*command, "marked.kfast", "--clip", "x", status=2, says="blink, sway")
            self.refuse(*command, "repeat.kfast", "--clip", "blink", status=2, says="the scene has none")
            for speed in ("0", "0.001", "17", "-17", "fast", "1x", "nan"):
                self.refuse(*command, "marked.kfast", f"--speed={speed}", status=2, says="is no speed")

    def test_size_and_fit_change_the_picture(self):
        sizes = [self.hashes("repeat.kfast", "--size", "64x64", "--scaling", fit)[1] for fit in ("contain", "cover", "none")]
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

    def test_a_frame_alone_is_the_one_among_all(self):
        for name in MOVING:
            scene = ROOT / "examples" / name
            self.run_kfast("render", scene, "--all", "-o", "frames")
            for frame in (38, 7, 23):
                with Image.open(self.folder / f"frames/{frame:04}.png") as played:
                    self.assertEqual(self.picture(scene, "--frame", frame)[1], played.convert("RGB").tobytes(), name)

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

    def test_clips(self):
        clip = ["marked.kfast", "--clip", "blink"]
        self.assertEqual(self.picture(*clip, "--frame", "1"), self.picture("marked.kfast", "--frame", "3"))
        self.assertEqual(self.picture(*clip, "--time", "1.5"), self.picture("marked.kfast", "--time", "3.5"))
        self.assertEqual(self.picture(*clip, "--time", "99s"), self.picture("marked.kfast", "--frame", "6"))
        self.assertEqual(self.picture(*clip, "--speed", "2", "--time", "1"), self.picture("marked.kfast", "--frame", "4"))
        self.assertEqual(self.picture(*clip, "--speed", "-1", "--frame", "1"), self.picture("marked.kfast", "--frame", "5"))
        self.refuse("render", *clip, "--frame", "5", "-o", "a.png", status=2, says="there are frames 0 to 4")

    def test_a_clip_as_a_gif(self):
        for options, count, repeats, duration in ((["blink"], 5, None, 160), (["sway"], 12, 0, 400),
                                                  (["sway", "--speed", "0.5"], 24, 0, 800),
                                                  (["sway", "--speed", "-2"], 6, 0, 200)):
            self.run_kfast("render", "marked.kfast", "--all", "-o", "out.gif", "--clip", *options)
            with Image.open(self.folder / "out.gif") as gif:
                self.assertEqual((gif.n_frames, gif.info.get("loop")), (count, repeats))
                durations = []
                for index in range(count):
                    gif.seek(index)
                    durations.append(gif.info["duration"])
            self.assertEqual(sum(durations), duration)

    def test_wrong_usage(self):
        render = ["render", "repeat.kfast"]
        self.refuse(*render, "--frame", "1", status=2, says="--output is required")
        self.refuse(*render, "-o", "a.png", "--frame", "1", "--all", status=2, says="--frame")
        self.refuse(*render, "-o", "a.png", "--frame", "10", status=2, says="there are frames 0 to 9")
        self.refuse(*render, "-o", "a.png", "--frame", "-1", status=2, says="there are frames 0 to 9")
        self.refuse(*render, "-o", "a.png", "--time", "1h", status=2, says="'1h' is no time")

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
        out = self.run_kfast("preview", "repeat.kfast", "--headless", "--press", "n n p space right").stdout
        shown = [int(line.split()[1]) for line in out.splitlines()[:-1]]
        self.assertEqual(shown, [4, 0, 4, 4, 6])
        hashes = [line.split()[1] for line in self.run_kfast("hash", "repeat.kfast").stdout.splitlines()]
        self.assertEqual([line.split()[-1] for line in out.splitlines()[:-1]], [hashes[i] for i in shown])

    def test_events_are_told(self):
        def events(*arguments):
            lines = self.run_kfast("preview", "marked.kfast", "--headless", *arguments).stdout.splitlines()
            return [line.removeprefix("event ") for line in lines if line.startswith("event ")]

        every = ["0 begin", "2.5 lid down", "4 shut", "4 shut2", "9.5 late"]
        self.assertEqual(events(), every)
        self.assertEqual(events("--panel", "ssd0323"), every)
        self.assertEqual(events("--speed", "16"), every)
        self.assertEqual(events("--speed", "-3"), ["0 begin", "9.5 late", "4 shut2", "4 shut", "2.5 lid down"])
        self.assertEqual(events("--clip", "blink", "--speed", "-1"), ["4 shut2", "4 shut", "2.5 lid down"])
        self.assertEqual(events("--clip", "sway"), ["4 shut", "4 shut2", "9.5 late"])

    def test_keys_change_speed_and_clip(self):
        out = self.run_kfast("preview", "marked.kfast", "--headless", "--press", "right up v space c space c b b").stdout
        states = [line.rsplit("  ", 1)[0] for line in out.splitlines() if line.startswith("frame")]
        self.assertEqual(states, [
            "frame 2  0.067 s  paused",
            "frame 2  0.067 s  paused  speed 2",
            "frame 2  0.067 s  paused  speed -2",
            "frame 2  0.067 s  playing  speed -2",
            "frame 6  0.200 s  playing  speed -2  clip blink",
            "frame 4  0.133 s  paused  event shut  speed -2  clip blink",
            "frame 10  0.333 s  playing  speed -2  clip sway",
            "frame 6  0.200 s  playing  speed -2  clip blink",
            "frame 0  0.000 s  playing  speed -2",
        ])

    def test_terminal_in_a_pipe_is_one_picture(self):
        out = self.run_kfast("preview", "repeat.kfast", "--terminal", environment={"COLORTERM": "truecolor"}).stdout
        self.assertEqual(out.count("\n"), 20)
        self.assertEqual(out.count("\u2580"), 60 * 20)
        self.assertIn("38;2;", out)
        out = self.run_kfast("preview", "repeat.kfast", "--terminal", environment={"COLORTERM": ""}).stdout
        self.assertIn("38;5;", out)

    def on_a_terminal(self, *arguments, interrupt=False, typed=()):
        """What is written to a terminal of 40 (80, to type) x 12 characters, and how the program ends.

        Of `typed`, pairs, the second is typed when the first has been written."""
        waiting = list(typed)
        master, slave = pty.openpty()
        fcntl.ioctl(slave, termios.TIOCSWINSZ, struct.pack("HHHH", 12, 80 if typed else 40, 0, 0))
        def take_terminal():  # as a shell does for a job in the foreground
            os.setsid()
            fcntl.ioctl(slave, termios.TIOCSCTTY, 0)

        player = subprocess.Popen([KFAST, "preview", "--terminal", *arguments], cwd=self.folder, stdout=slave,
                                  stdin=slave if typed else subprocess.DEVNULL,
                                  preexec_fn=take_terminal if typed else None)
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
            if waiting and waiting[0][0] in written:
                os.write(master, waiting.pop(0)[1])
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

    def test_a_terminal_tells_events_and_plays_clips(self):
        written, status = self.on_a_terminal("marked.kfast", "--clip", "blink", interrupt=False)
        self.assertEqual(status, 0)
        frames = [int(number) for number in re.findall(r"frame (\d+)", written)]
        self.assertEqual((frames[0], frames[-1]), (2, 6))
        self.assertRegex(written, r"event (shut2|lid)")

    def test_a_terminal_takes_keys(self):
        written, status = self.on_a_terminal("marked.kfast", "--loops", "1000", typed=(
            (b"frame 2", b"\x1b[B"), (b"speed 0.5", b"cc"), (b"clip sway", b" "), (b"paused", b"q")))
        self.assertEqual(status, 0)
        self.assertTrue(written.endswith("\x1b[0m\x1b[?25h"))

    def test_control_c_gives_the_cursor_back(self):
        written, status = self.on_a_terminal("repeat.kfast", "--loops", "1000", interrupt=True)
        self.assertEqual(status, -signal.SIGINT)
        self.assertTrue(written.endswith("\x1b[0m\x1b[?25h"))

    def test_no_display_falls_back_to_the_terminal(self):
        nowhere = {"DISPLAY": "", "WAYLAND_DISPLAY": "", "SDL_VIDEODRIVER": "", "ASAN_OPTIONS": "detect_leaks=0"}
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
        self.refuse(*preview, "--press", "n", status=2, says="--press requires --headless")
        self.refuse(*preview, "--headless", "--press", "n 7", status=2, says="'7' is no key")
        self.refuse(*preview, "--headless", "--terminal", status=2, says="excludes")
        self.refuse(*preview, "--terminal", "--loops", "0", status=2, says="--loops")
        self.refuse(*preview, "--headless", "--loops", "2", status=2, says="excludes")


if __name__ == "__main__":
    unittest.main()
