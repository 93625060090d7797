"""--beam of what draws, through the real command."""

import struct
import unittest
import zlib

from PIL import Image

from command_case import ROOT, CommandTest

LINES = """kfast 1
canvas 100 100 fps=30 frames=3
object o stroke="#ffffff" { key 0 { line 20 30 80 30
 line 20 70 80 70 } }
"""


class BeamTest(CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "lines.kfast").write_text(LINES)
        (self.folder / "empty.kfast").write_text("kfast 1\ncanvas 10 10\n")

    def picture(self, *arguments):
        self.run_kfast("render", *arguments, "--frame", "0", "-o", "out.png")
        with Image.open(self.folder / "out.png") as image:
            return image.convert("RGB")

    def test_a_picture_is_as_large_as_it_is_told(self):
        self.assertEqual(self.picture("lines.kfast", "--beam", "scope").size, (480, 480))
        self.assertEqual(self.picture("lines.kfast", "--beam", "galvo", "--size", "90x41").size, (90, 41))

    def test_each_beam_has_its_phosphor_unless_another_is_chosen(self):
        def on_the_line(*arguments):
            return self.picture("lines.kfast", "--size", "100x100", *arguments).getpixel((50, 31))

        red, green, blue = on_the_line("--beam", "scope")
        self.assertTrue(green > blue > red, (red, green, blue))
        red, green, blue = on_the_line("--beam", "scope", "--phosphor", "amber")
        self.assertTrue(red > green > blue, (red, green, blue))
        red, green, blue = on_the_line("--beam", "galvo")
        self.assertTrue(red == green == blue > 200, (red, green, blue))

    def test_a_wide_spot_and_a_long_decay_are_seen(self):
        def light(*arguments):
            return sum(self.picture("marked.kfast", "--beam", "scope", "--size", "99x99", *arguments).tobytes())

        self.assertGreater(light("--spot", "3"), 1.3 * light("--spot", "0.6"))
        self.assertNotEqual(light("--decay", "50"), light("--decay", "5"))

    def test_a_file_describes_a_beam(self):
        (self.folder / "my.kdl").write_text("beam galvo light-delay=0\n")
        mine = self.picture("lines.kfast", "--beam", "my.kdl")
        self.assertNotEqual(mine.tobytes(), self.picture("lines.kfast", "--beam", "galvo").tobytes())
        (self.folder / "same.kdl").write_text("beam galvo\n")
        same = self.picture("lines.kfast", "--beam", "same.kdl")
        self.assertEqual(same.tobytes(), self.picture("lines.kfast", "--beam", "galvo").tobytes())

    def test_a_gif_of_a_phosphor_has_one_palette(self):
        self.run_kfast("render", "lines.kfast", "--beam", "crt", "--size", "64x64", "--all", "-o", "out.gif")
        with Image.open(self.folder / "out.gif") as image:
            self.assertEqual((image.size, image.n_frames), ((64, 64), 3))
            self.assertLessEqual(len(image.getcolors()), 256)
            shown = image.convert("RGB").tobytes()
        self.assertEqual(shown, self.picture("lines.kfast", "--beam", "crt", "--size", "64x64").tobytes())

    def test_the_same_picture_whenever_it_is_asked_for(self):
        self.run_kfast("render", "marked.kfast", "--beam", "galvo", "--size", "60x60", "--all", "-o", "all")
        self.run_kfast("render", "marked.kfast", "--beam", "galvo", "--size", "60x60", "--frame", "6", "-o", "6.png")
        self.assertEqual((self.folder / "all/0006.png").read_bytes(), (self.folder / "6.png").read_bytes())

    def test_a_hash_is_that_of_the_points(self):
        lines = self.run_kfast("hash", "empty.kfast", "--beam", "scope").stdout.splitlines()
        parked = struct.pack("<hh4B", -32768, -32768, 0, 0, 0, 0)
        self.assertEqual(lines[0], f"0 {zlib.crc32(parked):08x}")
        lines = self.run_kfast("hash", "lines.kfast", "--beam", "galvo").stdout.splitlines()
        self.assertEqual([line.split()[0] for line in lines], ["0", "1", "2"])
        self.assertEqual(len({line.split()[1] for line in lines}), 1)

    def test_the_preview_tells_what_a_picture_takes(self):
        out = self.run_kfast("preview", "lines.kfast", "--beam", "crt", "--size", "50x50", "--headless",
                             "--press", "space t t").stdout.splitlines()
        self.assertNotIn("points", out[0])
        self.assertRegex(out[1], r"  \d+ points  \d+ Hz  lit 1\.2  blanked \d\.\d  [0-9a-f]{8}$")
        self.assertNotEqual(out[1].split()[-1], out[0].split()[-1])
        self.assertEqual(out[2], out[0])

    def test_wrong_options(self):
        for arguments, says in (
            (("render", "--frame", "0", "-o", "a.png", "--beam", "scop"), 'did you mean "scope"?'),
            (("render", "--frame", "0", "-o", "a.png", "--beam", "no.kdl"), "there is no such file"),
            (("render", "--frame", "0", "-o", "a.png", "--beam", "scope", "--panel", "st7789"), "excludes"),
            (("render", "--frame", "0", "-o", "a.png", "--beam", "scope", "--format", "mono1"), "excludes"),
            (("render", "--frame", "0", "-o", "a.png", "--beam", "scope", "--scaling", "cover"), "excludes"),
            (("render", "--frame", "0", "-o", "a.png", "--spot", "1"), "--spot requires --beam"),
            (("render", "--frame", "0", "-o", "a.png", "--beam", "scope", "--spot", "nan"), "not a number from 0.05 to 10"),
            (("render", "--frame", "0", "-o", "a.png", "--beam", "scope", "--decay", "0"), "not a number from 0.1 to 1000"),
            (("render", "--frame", "0", "-o", "a.png", "--beam", "scope", "--phosphor", "gren"), 'did you mean "green"?'),
            (("hash", "--beam", "scope", "--size", "4x4"), "excludes"),
            (("preview", "--headless", "--decay", "9"), "--decay requires --beam"),
        ):
            command, *rest = arguments
            result = self.run_kfast(command, "lines.kfast", *rest, status=1 if says.startswith(("did you mean \"scope", "there")) else 2)
            self.assertIn(says, result.stderr, arguments)
            self.assertFalse((self.folder / "a.png").exists())

    def test_examples_are_drawn_by_all_beams(self):
        for name in ("robot-eyes", "stick-figure"):
            for beam in ("scope", "crt", "galvo"):
                image = self.picture(ROOT / f"examples/{name}.kfast", "--beam", beam, "--size", "96x96")
                self.assertGreater(max(image.tobytes()), 120, (name, beam))


if __name__ == "__main__":
    unittest.main()
