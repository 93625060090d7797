"""Sheets that kfast render makes: sprites with their list, and the key frames."""

import json
import os
import unittest

from PIL import Image

from render_case import RenderTest


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

    def test_a_contact_sheet_of_much_has_smaller_pictures(self):
        said = self.run_kfast("render", "repeat.kfast", "--contact", "--size", "300x200", "--scale", "16", "-o", "keys.png").stdout
        self.assertRegex(said, r"^keys.png: 3 keys at 1/2 of their size, 4992x3744, ")
        self.assertEqual(self.opened("keys.png").size, (4992, 3744))
        said = self.run_kfast("render", "repeat.kfast", "--contact", "--panel", "ili9341", "--scale", "16", "-o", "keys.png").stdout
        self.assertIn("3 keys at 1/2 of their size", said)

    def test_a_contact_sheet_of_too_much_is_refused_at_once(self):
        keys = "".join(f"    key {frame} {{ rect {frame} 1 14 14 }}\n" for frame in range(100))
        (self.folder / "many.kfast").write_text(f"kfast 1\ncanvas 300 200 fps=30\nobject dot fill=white {{\n{keys}}}\n")
        self.refuse("render", "many.kfast", "--contact", "--scale", "64", "-o", "keys.png", status=1, says="no room for 100 keys")

    def test_limits_and_names(self):
        self.refuse("render", "once.kfast", "--sheet", "2", "-o", "a.gif", status=2, says="a sheet is a .png")
        self.refuse("render", "once.kfast", "--contact", "-o", "a", status=2, says="a contact sheet is a .png")
        self.refuse("render", "once.kfast", "--sheet", "0", "-o", "a.png", status=2, says="--sheet")
        self.refuse("render", "once.kfast", "--sheet", "1", "--scale", "64", "-o", "a.png", status=1, says="at most 16384 a side")
        os.rename(self.folder / "once.kfast", self.folder / "scene.json")
        self.refuse("render", "scene.json", "--sheet", "2", "-o", "scene.png", status=1, says="overwrite the scene itself")
        (self.folder / "b.json").mkdir()
        self.refuse("render", "repeat.kfast", "--sheet", "2", "-o", "b.png", status=1, says="not a folder")

    def test_a_list_without_its_sheet_is_not_written(self):
        (self.folder / "full.png").symlink_to("/dev/full")
        self.refuse("render", "once.kfast", "--sheet", "2", "-o", "full.png", status=1, says="No space left")


if __name__ == "__main__":
    unittest.main()
