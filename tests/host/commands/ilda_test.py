"""ILDA files, read here from scratch by the published layout: ilda_test.py <kfast>."""

import collections
import json
import struct
import unittest

from command_case import CommandTest

Section = collections.namedtuple("Section", "format name company number total projector records")
Point = collections.namedtuple("Point", "x y z blanked last colour")

# Of a record: without the palette's, which has three bytes of colour alone.
LAYOUTS = {0: ">hhhBB", 1: ">hhBB", 4: ">hhhBBBB", 5: ">hhBBBB"}

SCENE = """kfast 1
canvas 100 100 fps=10 loop={loop}
object a stroke="{colour}" width=2 {{
    key 0 {{ line 10 10 90 10 90 90 }}
    key 3 {{ line 10 20 90 20 90 80 }}
}}
object b stroke="#00ff00" width=2 {{ line 30 50 60 50 }}
"""


def sections(data):
    """All of a file, the closing one included; fails where it is not as the format says."""
    at, found = 0, []
    while True:
        magic, reserved, code, name, company, count, number, total, projector, last = struct.unpack_from(
            ">4s3sB8s8sHHHBB", data, at)
        assert magic == b"ILDA" and reserved == b"\0\0\0" and last == 0, (at, magic, reserved, last)
        at += 32
        layout = ">BBB" if code == 2 else LAYOUTS[code]
        records = [struct.unpack_from(layout, data, at + i * struct.calcsize(layout)) for i in range(count)]
        at += count * struct.calcsize(layout)
        found.append(Section(code, name.rstrip(b"\0"), company.rstrip(b"\0"), number, total, projector, records))
        if count == 0:
            assert at == len(data), f"{len(data) - at} bytes behind the end"
            return found


def point(code, record, palette):
    axes = 3 if code in (0, 4) else 2
    place, status, light = record[:axes], record[axes], record[axes + 1:]
    assert status & 0x3F == 0, status
    blanked, last = bool(status & 0x40), bool(status & 0x80)
    colour = palette[light[0]] if code in (0, 1) else light[::-1]  # blue, green, red
    return Point(place[0], place[1], place[2] if axes == 3 else 0, blanked, last, None if blanked else colour)


class IldaTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("still")

    def write(self, name, loop="repeat", colour="#ffffff"):
        (self.folder / f"{name}.kfast").write_text(SCENE.format(loop=loop, colour=colour))

    def export(self, name, *arguments):
        self.run_kfast("export", "--ild", f"{name}.kfast", "-o", "a.ild", *arguments)
        return sections((self.folder / "a.ild").read_bytes())

    def frames(self, found):
        """Of each frame its points, with what palette there is."""
        palette, frames = {24: (0, 255, 0), 56: (255, 255, 255), 0: (255, 0, 0)}, []
        for section in found[:-1]:
            if section.format == 2:
                palette = dict(enumerate(section.records))
            else:
                frames.append([point(section.format, record, palette) for record in section.records])
        return frames

    def test_every_field_of_every_format(self):
        for code in (0, 1, 4, 5):
            with self.subTest(format=code):
                found = self.export("still", "--ilda-format", code)
                self.assertEqual([section.format for section in found], [code] * 4)
                self.assertEqual([section.name for section in found], [b"still"] * 4)
                self.assertEqual([section.company for section in found], [b"KFAST"] * 4)
                self.assertEqual([section.number for section in found], [0, 1, 2, 3])
                self.assertEqual([section.total for section in found], [3] * 4)
                self.assertEqual([section.projector for section in found], [0] * 4)
                for points in self.frames(found):
                    self.assertEqual([p.last for p in points], [False] * (len(points) - 1) + [True])
                    self.assertEqual({p.z for p in points}, {0})
                    self.assertLessEqual({p.colour for p in points}, {None, (255, 255, 255), (0, 255, 0)})

    def test_frames_in_haste_and_colours_without_room_are_told(self):
        (self.folder / "few.kdl").write_text("beam galvo rate=(kHz)1 least-refresh=60\n")
        (self.folder / "fading.kfast").write_text("kfast 1\ncanvas 100 100 fps=100 frames=300\nobject a stroke=red {\n"
                                                  "  key 0 stroke=red { line 10 10 90 90 }\n"
                                                  "  key 299 stroke=\"#0010ff\"\n}\n")
        for arguments, says in ((["still"], ""), (["still", "--beam", "few.kdl"], "3 frames had to be drawn faster"),
                                (["fading"], ""), (["fading", "--ilda-format", "0"], "more colours than a palette has")):
            with self.subTest(arguments=arguments):
                name, *more = arguments
                told = self.run_kfast("export", "--ild", f"{name}.kfast", "-o", "a.ild", *more).stderr
                self.assertIn(says, told)
                self.assertEqual(told == "", says == "")

    def test_all_formats_tell_the_same_points(self):
        told = [self.frames(self.export("still", "--ilda-format", code)) for code in (0, 1, 4, 5)]
        self.assertTrue(any(p.blanked for p in told[0][0]) and any(not p.blanked for p in told[0][0]))
        for other in told[1:]:
            self.assertEqual(told[0], other)
        self.assertEqual(self.frames(self.export("still")), told[0], "format 5 is the usual one")

    def test_places_are_those_of_the_canvas_and_y_points_up(self):
        lit = [p for p in self.frames(self.export("still", "--beam", "scope"))[0] if not p.blanked]
        white = [p for p in lit if p.colour == (255, 255, 255)]
        self.assertAlmostEqual(max(p.x for p in white), 0.4 * 65536, delta=200)
        self.assertAlmostEqual(max(p.y for p in white), 0.4 * 65536, delta=200)
        self.assertAlmostEqual(min(p.y for p in white), -0.4 * 65536, delta=200)
        green = [p for p in lit if p.colour == (0, 255, 0)]
        self.assertLess(max(abs(p.y) for p in green), 200)
        self.assertAlmostEqual(max(p.x for p in green), 0.1 * 65536, delta=200)
        self.assertAlmostEqual(min(p.x for p in green), -0.2 * 65536, delta=200)

    def test_other_colours_bring_a_palette_that_begins_with_the_default_one(self):
        self.write("odd", colour="#010203")
        found = self.export("odd", "--ilda-format", 1)
        self.assertEqual([section.format for section in found], [2, 1, 1, 1, 1])
        palette = found[0].records
        self.assertEqual((found[0].number, found[0].total, len(palette)), (0, 0, 65))
        self.assertEqual([palette[i] for i in (0, 16, 24, 31, 40, 48, 56, 64)],
                         [(255, 0, 0), (255, 255, 0), (0, 255, 0), (0, 255, 255), (0, 0, 255), (255, 0, 255),
                          (255, 255, 255), (1, 2, 3)])
        self.assertEqual({p.colour for p in self.frames(found)[0]} - {None}, {(1, 2, 3), (0, 255, 0)})

    def test_one_play_has_the_frames_that_are_seen(self):
        for loop, count in (("repeat", 3), ("once", 4), ("ping-pong", 6)):
            with self.subTest(loop=loop):
                self.write("a", loop=loop)
                self.assertEqual(len(self.export("a")) - 1, count)
        self.write("a", loop="ping-pong")
        there_and_back = self.frames(self.export("a"))
        self.assertEqual(there_and_back[1], there_and_back[5])
        self.assertEqual(there_and_back[2], there_and_back[4])
        self.assertNotEqual(there_and_back[1], there_and_back[2])
        self.assertEqual(len(self.export("a", "--speed", "0.5")) - 1, 12)
        self.assertEqual(len(self.export("marked", "--clip", "blink")) - 1, 5, "with its end")

    def test_info_tells_what_is_in_the_file(self):
        points = self.frames(self.export("still", "--ilda-format", 4))
        flat = [p for frame in points for p in frame]
        facts = json.loads(self.run_kfast("info", "a.ild", "--json", "--point-rate", 1000).stdout)
        self.assertEqual(facts["frames"], 3)
        self.assertEqual(facts["formats"], [4])
        self.assertEqual(facts["points"], len(flat))
        self.assertEqual(facts["lit_points"], sum(not p.blanked for p in flat))
        self.assertEqual(facts["most_points"], max(map(len, points)))
        self.assertAlmostEqual(facts["seconds"], len(flat) / 1000)
        self.assertEqual(facts["least"], {"x": min(p.x for p in flat), "y": min(p.y for p in flat)})
        self.assertEqual(facts["most"], {"x": max(p.x for p in flat), "y": max(p.y for p in flat)})
        for key, blanked in (("longest_lit_step", False), ("longest_blanked_step", True)):
            steps = [((b.x - a.x) ** 2 + (b.y - a.y) ** 2) ** 0.5 for frame in points for a, b in zip(frame, frame[1:])
                     if b.blanked == blanked]
            self.assertAlmostEqual(facts[key], max(steps), delta=1)
        text = self.run_kfast("info", "a.ild").stdout
        self.assertIn("name        still, by KFAST\n", text)
        self.assertIn("format      4, palettes: 0\n", text)

    def test_info_tells_what_is_wrong_with_a_file(self):
        self.export("still")
        whole = (self.folder / "a.ild").read_bytes()
        (self.folder / "cut.ild").write_bytes(whole[:100])
        self.refuse("info", "cut.ild", status=1, says="cut.ild: no proper ILDA file: at byte 100: the file breaks off")
        (self.folder / "cut.ild").write_bytes(whole[:-32])
        self.refuse("info", "cut.ild", status=1, says="the closing section is missing")

    def test_wrong_usage(self):
        self.refuse("export", "--ild", "still.kfast", "--ilda-format", 3, status=2, says="--ilda-format")
        self.refuse("export", "--ild", "still.kfast", "--beam", "none", status=1, says="none")
        self.refuse("export", "--ild", "still.kfast", "--clip", "none", status=2, says="--clip")
        self.refuse("export", "--ild", "still.kfast", "--bits", 16, status=2, says="--bits requires --wav")
        self.refuse("export", "--ild", "still.kfast", "-o", "still.kfast", status=1, says="overwrite the scene")

    def test_a_full_disk_leaves_what_was_there(self):
        (self.folder / "a.ild").write_text("before")
        self.refuse("export", "--ild", "still.kfast", "-o", "a.ild", status=1, says="a.ild", limit=50)
        self.assertEqual((self.folder / "a.ild").read_text(), "before")


if __name__ == "__main__":
    unittest.main()
