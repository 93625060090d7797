"""The kinds of files that kfast render makes, read by others: Pillow, librsvg, ffmpeg. A program of the test's own in the
place of ffmpeg tells what it is given: render_test.py <kfast> <rsvg-convert> <ffmpeg, or -NOTFOUND>."""

import fractions
import json
import os
import shutil
import signal
import subprocess
import sys
import time
import unittest
import xml.etree.ElementTree as ElementTree

FFMPEG = sys.argv.pop()
RSVG = sys.argv.pop()

from PIL import Image

from command_case import KFAST, ROOT, CommandTest

sys.path.insert(0, str(ROOT / "tests" / "import"))
import compare_pictures

SVG = "{http://www.w3.org/2000/svg}"

# Curves, groups, opacity of several layers and of one, even-odd, caps, joins, dots and turns in space.
VARIED = """kfast 1
canvas 120 90 fps=30 background="#102030"
object both fill="#f0d040" stroke="#4060ff" width=6 join=round opacity=0.5 {
    key 0 { circle 30 30 r=20 }
    key 10 { rect 20 20 30 30 }
}
object single fill="#ff404080" {
    key 0 { rect 50 10 30 20 }
}
object hollow fill="#40ff40" rule=even-odd {
    key 0 { rect 60 40 30 30; rect 70 50 10 10 }
}
object open stroke="#ffffff" width=5 cap=square join=miter miter=2 {
    key 0 { path "M 10 60 L 20 80 L 30 60 L 34 80" }
}
object dot stroke="#ff80ff" width=9 cap=round {
    key 0 { path "M 100 20 L 100 20" }
}
group turned rotate-y=40 rotate-x=20 pivot-x=100 pivot-y=65 {
    object face fill="#80c0ff" stroke="#c00000" width=2 { key 0 { circle 100 65 r=15 } }
}
"""

# 29.97 frames a second, of which three are the same.
RESTING = """kfast 1
canvas 21 11 fps=29.97 loop={loop}
object dot fill="#f2f2f2" {{
    key 0 {{ rect 1 1 4 4 }}
    key 3 law=hold {{ rect 7 1 4 4 }}
    key 6 {{ rect 13 4 4 4 }}
}}
"""

# Tells its arguments, and how much it reads; FAKE_FFMPEG says how it ends.
FAKE = """#!{python}
import json, os, sys
how = os.environ["FAKE_FFMPEG"]
if how == "deaf":
    sys.exit("first\\nlast words")
pictures = sys.stdin.buffer.read()
if how == "ill":
    print("\\n".join(f"line {{i}}" for i in range(20)), file=sys.stderr)
    sys.exit(3)
with open(sys.argv[-1], "wb") as output:
    output.write(json.dumps({{"arguments": sys.argv[1:], "bytes": len(pictures)}}).encode())
"""


class RenderTest(CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "varied.kfast").write_text(VARIED)
        for loop in ("once", "repeat"):
            (self.folder / f"resting-{loop}.kfast").write_text(RESTING.format(loop=loop))

    def render(self, *arguments, **more):
        return self.run_kfast("render", *arguments, **more)

    def opened(self, name):
        with Image.open(self.folder / name) as image:
            return image.convert("RGB")

    def pictures(self, name):
        """Of an animation, as pairs of milliseconds and pixels."""
        found = []
        with Image.open(self.folder / name) as image:
            for index in range(getattr(image, "n_frames", 1)):
                image.seek(index)
                found.append((image.info.get("duration"), image.convert("RGB").tobytes()))
        return found

    def frames(self, *arguments):
        self.render(*arguments, "--all", "-o", "frames")
        files = sorted((self.folder / "frames").iterdir())
        pixels = [self.opened(file).tobytes() for file in files]
        shutil.rmtree(self.folder / "frames")
        return pixels


def chunks(png):
    at = 8
    while at < len(png):
        length = int.from_bytes(png[at:at + 4], "big")
        yield png[at + 4:at + 8].decode(), png[at + 8:at + 8 + length]
        at += 12 + length


class AnimatedPngTest(RenderTest):
    def controls(self, name):
        """Rectangle and delay of each picture."""
        found = []
        for kind, data in chunks((self.folder / name).read_bytes()):
            if kind == "fcTL":
                word = [int.from_bytes(data[i:i + 4], "big") for i in range(4, 20, 4)]
                found.append((tuple(word), fractions.Fraction(int.from_bytes(data[20:22], "big"),
                                                              int.from_bytes(data[22:24], "big"))))
        return found

    def test_pictures_loops_and_delays(self):
        for loop, count, plays in (("repeat", 10, 0), ("once", 11, 1), ("ping-pong", 20, 0)):
            for name in ("out.apng", "out.png"):
                self.render(f"{loop}.kfast", "--all", "-o", name)
            self.assertEqual((self.folder / "out.apng").read_bytes(), (self.folder / "out.png").read_bytes())
            with Image.open(self.folder / "out.apng") as image:
                self.assertEqual((image.n_frames, image.info["loop"]), (count, plays))
            shown = [pixels for _, pixels in self.pictures("out.apng")]
            played = self.frames(f"{loop}.kfast")
            self.assertEqual(shown[:len(played)], played)
            self.assertEqual({delay for _, delay in self.controls("out.apng")}, {fractions.Fraction(1, 30)})

    def test_resting_pictures_are_one_and_the_rest_is_what_changes(self):
        self.render("resting-once.kfast", "--all", "-o", "out.apng")
        frame = fractions.Fraction(100, 2997)
        self.assertEqual([delay / frame for _, delay in self.controls("out.apng")], [1, 1, 1, 3, 1])
        whole, *parts = [area for area, _ in self.controls("out.apng")]
        self.assertEqual(whole, (21, 11, 0, 0))
        self.assertEqual(parts[-1], (10, 7, 7, 1))
        self.assertEqual([pixels for _, pixels in self.pictures("out.apng")][-1], self.frames("resting-once.kfast")[-1])

    def test_scaled(self):
        self.render("resting-repeat.kfast", "--all", "--scale", "3", "-o", "large.png")
        self.render("resting-repeat.kfast", "--all", "-o", "small.png")
        large, small = self.pictures("large.png"), self.pictures("small.png")
        self.assertEqual(len(large), len(small))
        for (_, wide), (_, narrow) in zip(large, small):
            self.assertEqual(Image.frombytes("RGB", (21, 11), narrow).resize((63, 33), Image.NEAREST).tobytes(), wide)


class VectorTest(RenderTest):
    def compare(self, vector, picture, width):
        subprocess.run([RSVG, "--width", str(width), self.folder / vector, "-o", self.folder / "seen.png"], check=True)
        difference = compare_pictures.compare(self.folder / "seen.png", self.folder / picture)
        self.assertEqual(difference.problems(near=0.995, worst=12, mean=1), [], f"{vector}: {difference}")

    def test_looks_like_the_picture(self):
        examples = ROOT / "examples"
        scenes = [(self.folder / "varied.kfast", []), (examples / "stroller.kfast", []), (examples / "worm.kfast", []), (examples / "one-to-two.kfast", []),
                  (examples / "card.kfast", []), (examples / "jitterbug.kfast", []), (examples / "plot.kfast", []), (examples / "clock-face.kfast", ["--input", "clock=08:45"]),
                  (examples / "dial.kfast", ["--input", "speed=70", "--input", "mood=0.5"]), (examples / "logo.kfast", ["--size", "100x150"]),
                  (examples / "robot-eyes.kfast", ["--size", "90x150", "--fit", "cover"])]
        for scene, options in scenes:
            for frame in (0, 9):
                self.render(scene, *options, "--frame", frame, "-o", "out.svg")
                self.render(scene, *options, "--frame", frame, "-o", "out.png")
                self.compare("out.svg", "out.png", self.opened("out.png").width)

    def test_a_fill_that_breaks_in_two(self):
        (self.folder / "broken.kfast").write_text("""kfast 1
canvas 120 90 fps=30
object parting fill="#ffffff" {
    key 0 { rect 10 10 100 70 }
    key 10 { circle 30 45 r=20; circle 90 45 r=20; rect 50 5 20 10 }
}
""")
        for frame in (2, 5):
            self.render("broken.kfast", "--frame", frame, "-o", "out.svg")
            self.render("broken.kfast", "--frame", frame, "-o", "out.png")
            self.compare("out.svg", "out.png", 120)

    def test_paths_tell_what_they_are(self):
        self.render("varied.kfast", "--frame", "0", "-o", "out.svg")
        picture = ElementTree.parse(self.folder / "out.svg").getroot()
        self.assertEqual([element.tag.removeprefix(SVG) for element in picture], ["rect", "g", *["path"] * 5])
        self.assertEqual(picture[1].attrib, {"opacity": "0.502"})
        both = picture[1][0].attrib
        self.assertEqual((both["fill"], both["stroke"], both["stroke-width"], both["stroke-linejoin"]),
                         ("#f0d040", "#4060ff", "6", "round"))
        self.assertEqual(both["d"].count("C"), 4)
        self.assertEqual(picture[2].attrib, {"fill": "#ff4040", "fill-opacity": "0.502", "d": "M50 10L80 10L80 30L50 30L50 10Z"})
        self.assertEqual(picture[3].attrib["fill-rule"], "evenodd")
        self.assertEqual((picture[4].attrib["stroke-linecap"], picture[4].attrib["stroke-miterlimit"], picture[4].attrib["fill"]),
                         ("square", "2", "none"))
        self.assertNotIn("C", picture[6].attrib["d"], "curves in space become lines")

    def test_fractions_are_exact_to_a_sixteenth(self):
        (self.folder / "fine.kfast").write_text('kfast 1\ncanvas 9 9\nobject a fill="#ffffff" { key 0 { rect 1.0625 -2.9375 3 4 } }\n')
        self.render("fine.kfast", "--frame", "0", "-o", "out.svg")
        self.assertIn('d="M1.0625 -2.9375L4.0625 -2.9375L4.0625 1.0625L1.0625 1.0625L1.0625 -2.9375Z"',
                      (self.folder / "out.svg").read_text())

    def test_a_folder_of_vectors(self):
        self.render("once.kfast", "--all", "--kind", "svg", "-o", "frames")
        self.assertEqual(sorted(path.name for path in (self.folder / "frames").iterdir()), [f"{i:04}.svg" for i in range(11)])
        self.render("once.kfast", "--frame", "4", "-o", "4.svg")
        self.assertEqual((self.folder / "frames/0004.svg").read_bytes(), (self.folder / "4.svg").read_bytes())

    def test_an_animated_vector_takes_turns(self):
        for loop, ending in (("once", {"fill": "freeze"}), ("repeat", {"repeatCount": "indefinite"})):
            self.render(f"resting-{loop}.kfast", "--all", "-o", "out.svg")
            picture = ElementTree.parse(self.folder / "out.svg").getroot()
            frames = picture.findall(f"{SVG}g")
            turns = [frame.find(f"{SVG}animate").attrib for frame in frames]
            self.assertEqual([frame.get("display") for frame in frames], [None] + ["none"] * (len(frames) - 1))
            count = 7 if loop == "once" else 6
            self.assertEqual(len(frames), 5 if loop == "once" else 4)
            for turn in turns:
                self.assertEqual({key: turn.get(key) for key in ending}, ending)
                self.assertAlmostEqual(float(turn["dur"].removesuffix("s")), count / 29.97, places=6)
            times = [[round(float(time) * count, 5) for time in turn["keyTimes"].split(";")] for turn in turns]
            ends = [[0, 3, 6], [0, 6]] if loop == "once" else [[0, 3]]
            self.assertEqual(times, [[0, 1], [0, 1, 2], [0, 2, 3], *ends])
            self.assertEqual(turns[1]["values"], "none;inline;none")
        self.render("resting-once.kfast", "--frame", "0", "-o", "out.png")
        self.compare("out.svg", "out.png", 21)

    def test_what_cannot_be_a_vector(self):
        svg = ["render", "once.kfast", "--frame", "1", "-o", "a.svg"]
        self.refuse(*svg, "--beam", "scope", status=2, says="no outlines")
        self.refuse(*svg, "--format", "mono1", status=2, says="no pixels")
        self.refuse(*svg, "--scale", "2", status=2, says="choose --size")
        self.refuse("render", "once.kfast", "--all", "--kind", "svg", "--scale", "2", "-o", "f", status=2, says="choose --size")


class SheetTest(RenderTest):
    def test_a_sprite_sheet_and_its_list(self):
        self.render("once.kfast", "--sheet", "4", "--scale", "2", "-o", "sheet.png")
        sheet, told = self.opened("sheet.png"), json.loads((self.folder / "sheet.json").read_text())
        self.assertEqual((sheet.size, told["width"], told["height"]), ((480, 240), 480, 240))
        self.assertEqual((told["image"], told["columns"], told["loop"], len(told["frames"])), ("sheet.png", 4, "once", 11))
        frames = self.frames("once.kfast", "--scale", "2")
        for frame, pixels in zip(told["frames"], frames):
            x, y, width, height = (frame[key] for key in ("x", "y", "width", "height"))
            self.assertEqual(sheet.crop((x, y, x + width, y + height)).tobytes(), pixels)
            self.assertAlmostEqual(frame["milliseconds"], 1000 / 30)

    def test_a_sheet_of_ping_pong_has_each_picture_once(self):
        for options, count, loop in (([], 11, "ping-pong"), (["--way-back"], 20, "repeat")):
            self.render("ping-pong.kfast", "--sheet", "100", *options, "-o", "sheet.png")
            told = json.loads((self.folder / "sheet.json").read_text())
            self.assertEqual((len(told["frames"]), told["loop"]), (count, loop))
            self.assertEqual(self.opened("sheet.png").size, (count * 60, 40))
            self.render("once.kfast", "--sheet", "100", "-o", "once.png")
            there = self.opened("once.png")
            self.assertEqual(self.opened("sheet.png").crop((0, 0, *there.size)).tobytes(), there.tobytes())
        self.render("repeat.kfast", "--sheet", "100", "--way-back", "-o", "sheet.png")
        told = json.loads((self.folder / "sheet.json").read_text())
        self.assertEqual((len(told["frames"]), told["loop"]), (10, "repeat"))
        self.refuse("render", "once.kfast", "--all", "--way-back", "-o", "a.gif", status=2, says="it is for --sheet")

    def test_a_wide_sheet_has_no_empty_columns(self):
        self.render("once.kfast", "--sheet", "1000", "-o", "sheet.png")
        self.assertEqual(self.opened("sheet.png").size, (660, 40))

    def test_a_contact_sheet_shows_the_keys(self):
        self.render("repeat.kfast", "--contact", "-o", "keys.png")
        sheet = self.opened("keys.png")
        self.assertEqual(sheet.size, (4 + 2 * 70, 4 + 2 * 55))  # cells as wide as "10  0.333 s"
        for frame, (x, y) in ((0, (4, 4)), (4, (74, 4))):
            self.render("repeat.kfast", "--frame", frame, "-o", "frame.png")
            self.assertEqual(sheet.crop((x, y, x + 60, y + 40)).tobytes(), self.opened("frame.png").tobytes())
        label = sheet.crop((74, 48, 80, 55)).convert("L").point(lambda level: 255 * (level > 128))
        self.assertEqual(["".join(".#"[label.getpixel((x, y)) > 0] for x in range(6)) for y in range(7)],
                         ["...#..", "..##..", ".#.#..", "#..#..", "#####.", "...#..", "...#.."], "a 4")

    def test_a_contact_sheet_of_a_clip_or_enlarged(self):
        self.render("marked.kfast", "--contact", "--clip", "blink", "-o", "keys.png")
        self.assertEqual(self.opened("keys.png").height, 4 + 55, "no key between 2 and 6: only its beginning")
        self.render("marked.kfast", "--contact", "--clip", "blink", "--scale", "2", "-o", "large.png")
        small = self.opened("keys.png")
        self.assertEqual(self.opened("large.png").tobytes(),
                         small.resize((2 * small.width, 2 * small.height), Image.NEAREST).tobytes())

    def test_limits_and_names(self):
        self.refuse("render", "once.kfast", "--sheet", "2", "-o", "a.gif", status=2, says="a sheet is a .png")
        self.refuse("render", "once.kfast", "--contact", "-o", "a", status=2, says="a contact sheet is a .png")
        self.refuse("render", "once.kfast", "--sheet", "0", "-o", "a.png", status=2, says="--sheet")
        self.refuse("render", "once.kfast", "--sheet", "1", "--scale", "64", "-o", "a.png", status=1, says="at most 16384 a side")
        os.rename(self.folder / "once.kfast", self.folder / "scene.json")
        self.refuse("render", "scene.json", "--sheet", "2", "-o", "scene.png", status=1, says="overwrite the scene itself")
        (self.folder / "b.json").mkdir()
        self.refuse("render", "repeat.kfast", "--sheet", "2", "-o", "b.png", status=1, says="not a folder")


class VideoTest(RenderTest):
    def fake(self, how):
        tools = self.folder / "tools"
        tools.mkdir(exist_ok=True)
        (tools / "ffmpeg").write_text(FAKE.format(python=sys.executable))
        (tools / "ffmpeg").chmod(0o755)
        return {"PATH": f"{tools}:{os.environ['PATH']}", "FAKE_FFMPEG": how}

    def given(self, *arguments):
        result = self.render(*arguments, environment=self.fake("well"))
        told = json.loads((self.folder / arguments[-1]).read_text())
        return told["arguments"], told["bytes"], result.stderr

    def test_what_ffmpeg_is_given(self):
        arguments, count, said = self.given("repeat.kfast", "--all", "--loops", "3", "-o", "out.mp4")
        self.assertEqual((count, said), (3 * 10 * 60 * 40 * 3, ""))
        command = " ".join(arguments)
        for part in ("-f rawvideo -pix_fmt rgb24 -video_size 60x40 -framerate 30 -i pipe:0", "-c:v libx264", "-pix_fmt yuv420p",
                     "-f mp4"):
            self.assertIn(part, command)
        arguments, count, _ = self.given("ping-pong.kfast", "--all", "--scale", "2", "-o", "out.webm")
        self.assertEqual(count, 20 * 120 * 80 * 3)
        self.assertIn("-c:v libvpx-vp9", " ".join(arguments))

    def test_closed_standard_files_are_no_pipes(self):
        environment = {**os.environ, **self.fake("well")}
        for closed in ([0], [1], [2], [0, 1, 2]):
            def close(numbers=closed):
                for number in numbers:
                    os.close(number)

            subprocess.run([KFAST, "render", "repeat.kfast", "--all", "-o", "out.mp4"], cwd=self.folder, env=environment,
                           preexec_fn=close, timeout=120, check=True)
            self.assertEqual(json.loads((self.folder / "out.mp4").read_text())["bytes"], 10 * 60 * 40 * 3)
            (self.folder / "out.mp4").unlink()

    def test_odd_sides_get_a_pixel(self):
        arguments, count, said = self.given("resting-once.kfast", "--all", "-o", "out.mp4")
        self.assertIn("-video_size 22x12 -framerate 2997/100", " ".join(arguments))
        self.assertEqual(count, 7 * 22 * 12 * 3)
        self.assertIn("sides of even length", said)

    def test_failures_leave_no_file(self):
        video = ["render", "repeat.kfast", "--all", "-o", "out.mp4"]
        environment = self.fake("ill")
        self.refuse(*video, status=1, says="line 19", environment=environment)
        self.assertNotIn("line 11\n", self.run_kfast(*video, status=1, environment=environment).stderr)
        environment = self.fake("deaf")
        self.refuse(*video, "--scale", "16", status=1, says="last words", environment=environment)
        self.refuse(*video, status=1, says="apt install ffmpeg", environment={"PATH": str(self.folder)})
        self.refuse("render", "repeat.kfast", "--all", "-o", "no/out.mp4", status=1, says="create the folder first")
        (self.folder / "old.mp4").write_text("old")
        self.refuse("render", "repeat.kfast", "--all", "-o", "old.mp4", status=1, says="line 19", environment=self.fake("ill"))
        self.assertEqual((self.folder / "old.mp4").read_text(), "old")

    def test_an_interruption_leaves_no_file(self):
        environment = {**os.environ, **self.fake("well")}
        player = subprocess.Popen([KFAST, "render", "repeat.kfast", "--all", "--loops", "1000", "--scale", "32", "-o", "out.mp4"],
                                  cwd=self.folder, env=environment)
        deadline = time.monotonic() + 60
        while not list(self.folder.glob(".kfast-*")) and time.monotonic() < deadline:
            time.sleep(0.01)
        player.send_signal(signal.SIGTERM)
        self.assertEqual(player.wait(timeout=60), -signal.SIGTERM)
        self.assertEqual([path.name for path in self.folder.iterdir() if path.suffix in (".mp4", ".tmp")], [])

    @unittest.skipUnless(os.access(FFMPEG, os.X_OK), "there is no ffmpeg")
    def test_a_true_video(self):
        (self.folder / "bin").mkdir()
        (self.folder / "bin/ffmpeg").symlink_to(FFMPEG)
        for name in ("out.mp4", "out.webm"):
            self.render("once.kfast", "--all", "--scale", "4", "-o", name, environment={"PATH": str(self.folder / "bin")})
            subprocess.run([FFMPEG, "-v", "error", "-i", name, "frame-%02d.png"], cwd=self.folder, check=True)
            self.assertEqual(len(list(self.folder.glob("frame-*.png"))), 11)
            for frame in (0, 7):
                self.render("once.kfast", "--frame", frame, "--scale", "4", "-o", "frame.png")
                difference = compare_pictures.compare(self.folder / f"frame-{frame + 1:02}.png", self.folder / "frame.png")
                self.assertEqual(difference.problems(), [], f"{name}: {difference}")
            for file in self.folder.glob("frame-*.png"):
                file.unlink()


class UsageTest(RenderTest):
    def test_names_and_options_that_do_not_fit(self):
        render = ["render", "repeat.kfast"]
        self.refuse(*render, "--all", "-o", "a.jpg", status=2, says="choose .png, .svg, .apng, .gif, .mp4, .webm")
        self.refuse(*render, "--frame", "1", "-o", "a.jpg", status=2, says="'.jpg' is no kind")
        for kind in ("apng", "gif", "mp4", "webm"):
            self.refuse(*render, "--frame", "1", "-o", f"a.{kind}", status=2, says=f"add --all for a .{kind}")
        self.refuse(*render, "--all", "--kind", "svg", "-o", "a.png", status=2, says="files in a folder")
        self.refuse(*render, "--all", "--kind", "pdf", "-o", "a", status=2, says="--kind")
        self.refuse(*render, "--all", "--loops", "2", "-o", "a.gif", status=2, says="it is for videos")
        self.refuse(*render, "--all", "--loops", "0", "-o", "a.mp4", status=2, says="--loops")
        self.refuse(*render, "--all", "--scale", "0", "-o", "a.gif", status=2, says="--scale")
        self.refuse(*render, "--contact", "--all", "-o", "a.png", status=2, says="--contact")

    def test_endings_in_capitals_and_folders_with_a_dot(self):
        self.render("repeat.kfast", "--all", "-o", "A.GIF")
        self.assertEqual((self.folder / "A.GIF").read_bytes()[:3], b"GIF")
        (self.folder / "v1.2").mkdir()
        for name in ("v1.2", "v1.3/"):
            self.render("repeat.kfast", "--all", "-o", name)
            self.assertEqual(len(list((self.folder / name).iterdir())), 10)

    def test_no_room(self):
        for name in ("full.apng", "full.png", "full.svg"):
            (self.folder / name).symlink_to("/dev/full")
            self.refuse("render", "repeat.kfast", "--all", "-o", name, status=1, says="make room")
        for name in ("a.apng", "a.svg"):
            self.refuse("render", "repeat.kfast", "--all", "-o", name, status=1, says="make room", limit=64)
        self.refuse("render", "repeat.kfast", "--sheet", "3", "-o", "a.png", status=1, says="make room", limit=64)

    def test_no_room_for_a_video(self):
        for name in ("a.mp4", "a.webm"):
            (self.folder / name).write_bytes(b"before")
            self.refuse("render", "repeat.kfast", "--all", "-o", name, status=1, says="ffmpeg failed", limit=512)
            self.assertEqual((self.folder / name).read_bytes(), b"before")

    def test_a_list_without_room_leaves_the_sheet_of_before(self):
        (self.folder / "old.json").mkdir()
        (self.folder / "old.png").write_bytes(b"before")
        self.refuse("render", "repeat.kfast", "--sheet", "3", "-o", "old.png", status=1, says="name a file, not a folder")
        self.assertEqual((self.folder / "old.png").read_bytes(), b"before")

    def test_panels_clips_and_beams(self):
        self.render("marked.kfast", "--clip", "blink", "--speed", "-1", "--all", "-o", "out.apng")
        shown = [pixels for _, pixels in self.pictures("out.apng")]
        self.assertEqual(shown, self.frames("marked.kfast", "--clip", "blink", "--speed", "-1"))
        self.render("marked.kfast", "--panel", "ssd1306", "--sheet", "5", "-o", "sheet.png")
        self.assertEqual(self.opened("sheet.png").size, (640, 128))
        self.render("marked.kfast", "--panel", "ssd1306", "--frame", "0", "-o", "out.svg")
        self.assertIn('viewBox="0 0 128 64"', (self.folder / "out.svg").read_text())
        self.render("marked.kfast", "--beam", "scope", "--size", "100x100", "--clip", "blink", "--all", "-o", "out.png")
        self.assertEqual(self.opened("out.png").size, (100, 100))

    def test_long_work_is_seen_on_a_terminal_alone(self):
        self.assertEqual(self.written_to_a_terminal("render", "repeat.kfast", "--all", "-o", "out.gif"), "")
        long = ["--speed", "0.01", "--size", "500x400", "--format", "rgb666"]
        written = self.written_to_a_terminal("hash", "repeat.kfast", *long)
        self.assertRegex(written, r"\rdrawing \[#* *\] +\d+ %  \d+ s left")
        self.assertRegex(written, r"\r +\r$")


if __name__ == "__main__":
    unittest.main()
