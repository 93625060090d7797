"""Runs the real command in every way it can be used: command_test.py <kfast>."""

import fcntl
import json
import os
import pathlib
import pty
import re
import resource
import signal
import struct
import subprocess
import sys
import tempfile
import termios
import time
import unittest
import zlib

from PIL import Image

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

    def compiled(self):
        self.run_kfast("compile", "repeat.kfast")
        return bytearray((self.folder / "repeat.kfb").read_bytes())


class CompileTest(CommandTest):
    def test_writes_beside_the_scene_and_says_what(self):
        line = self.run_kfast("compile", "repeat.kfast").stdout
        size = (self.folder / "repeat.kfb").stat().st_size
        self.assertRegex(line, rf"^repeat.kfb: {size} bytes, 10 frames, 1 object, \d+ bytes of memory at 60x40\n$")
        self.assertEqual(len(list(self.folder.iterdir())), 4)

    def test_writes_where_told(self):
        self.run_kfast("compile", "repeat.kfast", "-o", "other.bin")
        self.run_kfast("compile", "repeat.kfast")
        self.assertEqual((self.folder / "other.bin").read_bytes(), (self.folder / "repeat.kfb").read_bytes())

    def test_never_overwrites_its_input(self):
        self.refuse("compile", "repeat.kfast", "-o", "repeat.kfast", status=1, says="overwrite the scene itself")
        self.refuse("compile", "repeat.kfast", "-o", "./repeat.kfast", status=1, says="overwrite the scene itself")
        os.rename(self.folder / "repeat.kfast", self.folder / "text.kfb")
        self.refuse("compile", "text.kfb", status=1, says="overwrite the scene itself")

    def test_takes_no_compiled_scene(self):
        self.compiled()
        self.refuse("compile", "repeat.kfb", status=1, says="compiled already")

    def test_unwritable_outputs(self):
        self.refuse("compile", "repeat.kfast", "-o", "none/a.kfb", status=1, says="create the folder first")
        self.refuse("compile", "repeat.kfast", "-o", ".", status=1, says="name a file, not a folder")
        self.refuse("compile", "repeat.kfast", "-o", "/dev/full", status=1, says="No space left")

    def test_a_full_disk_keeps_the_earlier_file(self):
        before = self.compiled()
        self.refuse("compile", "once.kfast", "-o", "repeat.kfb", status=1, says="make room", limit=50)
        self.assertEqual((self.folder / "repeat.kfb").read_bytes(), before)


class InputTest(CommandTest):
    COMMANDS = (["check"], ["info"], ["hash"], ["preview", "--headless"], ["render", "--all", "-o", "out"],
                ["compile", "-o", "out"])

    def everywhere(self, name, says):
        for command in self.COMMANDS:
            with self.subTest(command=command):
                self.refuse(*command, name, status=1, says=says)

    def write(self, name, content):
        (self.folder / name).write_bytes(content)
        return name

    def test_missing(self):
        self.everywhere("none.kfast", "none.kfast: there is no such file")

    def test_folder(self):
        self.everywhere(".", "this is a folder")

    def test_empty(self):
        self.everywhere(self.write("empty.kfast", b""), "empty.kfast: the file is empty")

    def test_binary(self):
        self.everywhere(self.write("binary.kfast", bytes(range(256)) * 9), "neither a scene nor a compiled scene")

    def test_huge(self):
        with open(self.folder / "huge.kfast", "wb") as file:
            file.truncate((16 << 20) + 1)
        self.everywhere("huge.kfast", "larger than 16 MB")

    def test_huge_text(self):
        good = SCENE.format(loop="repeat").encode()
        self.run_kfast("check", self.write("largest.kfast", good.ljust(4 << 20)))
        self.everywhere(self.write("larger.kfast", good.ljust((4 << 20) + 1)), "a text larger than 4 MB")

    def test_wrong_text(self):
        text = SCENE.format(loop="repeat").replace("rect 40", "rekt 40")
        self.everywhere(self.write("wrong.kfast", text.encode()), "wrong.kfast:5:")

    def test_truncated(self):
        self.everywhere(self.write("short.kfb", self.compiled()[:-5]), "breaks off before its end")
        self.everywhere(self.write("shorter.kfb", b"KFB"), "breaks off before its end")

    def test_newer(self):
        scene = self.compiled()
        scene[3] = 9
        self.everywhere(self.write("newer.kfb", scene),
                        "newer.kfb: made by a newer kfast (format 9, this one reads 1): update kfast, or compile")

    def test_damaged(self):
        scene = self.compiled()
        scene[-1] ^= 1
        self.everywhere(self.write("damaged.kfb", scene), "damaged on the way")

    def test_contradicting(self):
        scene = self.compiled()
        scene[24:26] = b"\0\0"  # the width of the canvas
        scene[4:8] = zlib.crc32(scene[8:]).to_bytes(4, "little")
        self.everywhere(self.write("bad.kfb", scene), "contradicts itself")

    @unittest.skipIf(os.geteuid() == 0, "root may read everything")
    def test_unreadable(self):
        (self.folder / "repeat.kfast").chmod(0)
        self.everywhere("repeat.kfast", "you may not read it")

    def test_the_content_decides_what_a_file_is(self):
        self.run_kfast("compile", "repeat.kfast", "-o", "binary.kfast")
        os.rename(self.folder / "repeat.kfast", self.folder / "text.kfb")
        self.assertEqual(self.run_kfast("hash", "binary.kfast").stdout, self.run_kfast("hash", "text.kfb").stdout)


class CheckTest(CommandTest):
    def test_a_good_scene(self):
        self.assertRegex(self.run_kfast("check", "repeat.kfast").stdout, r"^repeat.kfast: ok: .*, 0 warnings\n$")

    def test_warnings_are_counted_and_do_not_fail(self):
        path = self.folder / "repeat.kfast"
        path.write_text(path.read_text().replace("key 10 ", "key 10 law=accelerate "))
        result = self.run_kfast("check", "repeat.kfast")
        self.assertIn(", 1 warning\n", result.stdout)
        self.assertIn("repeat.kfast:6:12: warning: ", result.stderr)
        self.assertNotIn("\x1b", result.stderr, "colour is for terminals")

    def test_all_errors_in_one_run(self):
        path = self.folder / "repeat.kfast"
        path.write_text(path.read_text().replace("rect", "rekt"))
        self.refuse("check", "repeat.kfast", status=1, says="kfast: repeat.kfast: 3 errors")


class InfoTest(CommandTest):
    def test_json(self):
        facts = json.loads(self.run_kfast("info", "repeat.kfast", "--json").stdout)
        memory = facts.pop("memory")
        self.assertEqual(facts, {
            "file": "repeat.kfast", "bytes": len(self.compiled()), "canvas": {"width": 60, "height": 40}, "fps": 30,
            "frames": 10, "seconds": 10 / 30, "loop": "repeat", "objects": 1, "keys": [0, 4, 10]})
        self.assertEqual((memory["width"], memory["height"]), (60, 40))

    def test_text(self):
        text = self.run_kfast("info", "ping-pong.kfast", "--panel", "ssd0323").stdout
        self.assertRegex(text, r"loop +ping-pong\n")
        self.assertRegex(text, r"keys +3, at frames 0 4 10\n")
        self.assertRegex(text, r"memory +\d+ bytes for a panel of 128x64\n")


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


class UsageTest(CommandTest):
    def test_help_everywhere(self):
        example = re.search(r"Example:\n  kfast preview (\S+)", self.run_kfast("--help").stdout)
        self.assertTrue((ROOT / example[1]).is_file(), "the first example can be typed as it stands")
        for command in ("compile", "check", "info", "render", "preview", "hash"):
            self.assertIn(f"  kfast {command} ", self.run_kfast(command, "--help").stdout)

    def test_version(self):
        self.assertRegex(self.run_kfast("--version").stdout, r"^kfast \d+\.\d+\.\d+\n$")

    def test_wrong_usage(self):
        self.refuse(status=2, says="a command is missing")
        self.refuse("hsh", "repeat.kfast", status=2, says='did you mean "hash"?')
        self.refuse("hash", status=2, says="FILE is required")
        self.refuse("hash", "repeat.kfast", "--frobnicate", status=2, says="--frobnicate")
        self.refuse("hash", "repeat.kfast", "extra", status=2, says="extra")

    def test_wrong_pictures(self):
        scene = ["hash", "repeat.kfast"]
        for size in ("0x1", "1x0", "4097x1", "1x4097", "3", "3x", "x3", "3x3x3", "-3x3", "3 x 3", "99999999999x1"):
            self.refuse(*scene, f"--size={size}", status=2, says="write it like 240x135")
        self.refuse(*scene, "--fit", "containt", status=2, says='did you mean "contain"?')
        self.refuse(*scene, "--format", "rgb888", status=2, says="rgb565")
        self.refuse(*scene, "--panel", "sdd0323", status=2, says="ssd0323")
        for option, value in (("--size", "9x9"), ("--fit", "none"), ("--format", "mono1")):
            self.refuse(*scene, "--panel", "ssd0323", option, value, status=2, says="--panel")

    def test_the_largest_picture(self):
        self.run_kfast("render", "repeat.kfast", "--frame", "0", "--size", "4096x4096", "--format", "mono1", "-o", "a.png")


if __name__ == "__main__":
    unittest.main()
