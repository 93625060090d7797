"""What kfast fit, info and render say of scenes whose outlines find no room."""

import json
import unittest
import zlib

from command_case import CommandTest

CHECKSUM_END = 8

# From its second frame on, more than the first one.
DOTS = """kfast 1
canvas 128 64 frames=4
object dot fill=white { rect 1 1 4 4 }
object dots fill=white { key 0 visible=#false; key 1 visible=#true; circle 14 20 r=12; circle 44 20 r=12 }
"""
NO_ROOM = 480  # bytes: too few for both circles, however coarse they are
SCARCE = 800  # enough if they are coarse


def varint_end(data, begin):
    return next(at for at in range(begin, len(data)) if data[at] < 128) + 1


def with_outline_room(compiled, size):
    """A scene whose header promises `size` bytes for outlines, a multiple of 4 with no more digits than before (docs/format.md)."""
    data = bytearray(compiled)
    begin = varint_end(data, CHECKSUM_END)  # behind the size of what follows
    end = varint_end(data, begin)
    digits = end - begin
    assert size % 4 == 0 and size // 4 < 128**digits
    for digit in range(digits):
        more = 128 if digit < digits - 1 else 0
        data[begin + digit] = size // 4 >> 7 * digit & 127 | more
    data[4:CHECKSUM_END] = zlib.crc32(data[CHECKSUM_END:]).to_bytes(4, "little")
    return bytes(data)


class OutlineRoomTest(CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / "dots.kfast").write_text(DOTS)
        self.run_kfast("compile", "dots.kfast")

    def give_room(self, size):
        compiled = (self.folder / "dots.kfb").read_bytes()
        (self.folder / "scarce.kfb").write_bytes(with_outline_room(compiled, size))

    def fit(self, file, status=0):
        return json.loads(self.run_kfast("fit", file, "--board", "pico", "--panel", "ssd1306", "--json", status=status).stdout)

    def test_fit_counts_coarser_pictures_and_notes_them(self):
        report = self.fit("dots.kfb")
        self.assertEqual(report["coarse_pictures"], 0)
        self.assertNotIn("curves", " ".join(report["notes"]))
        self.give_room(SCARCE)
        report = self.fit("scarce.kfb")
        self.assertTrue(report["fits"])
        self.assertEqual(report["coarse_pictures"], 6)  # of frames, and of moments half a frame later
        self.assertIn("6 of 8 pictures have coarser curves", report["notes"][-1])
        self.give_room(NO_ROOM)
        self.assertIn("parts of the picture are missing", self.fit("scarce.kfb", status=1)["reasons"][0])

    def test_info_counts_coarser_pictures(self):
        self.assertNotIn("detail", self.run_kfast("info", "dots.kfb").stdout)
        self.give_room(SCARCE)
        self.assertIn("too little for all detail of 3 of 4 pictures that were tried", self.run_kfast("info", "scarce.kfb").stdout)
        memory = json.loads(self.run_kfast("info", "scarce.kfb", "--json").stdout)["memory"]
        self.assertEqual((memory["coarse_pictures"], memory["of_pictures"]), (3, 4))

    def test_render_says_so_once_for_all_kinds_of_pictures(self):
        for size, says in ((SCARCE, "curves are coarser"), (NO_ROOM, "parts of the picture are missing")):
            self.give_room(size)
            for arguments in (("-o", "a.gif"), ("-o", "a.apng", "--scale", "2"), ("--panel", "ssd1306", "-o", "a.gif"), ("--sheet", "2", "-o", "a.png"),
                              ("--contact", "-o", "a.png"), ("--frame", "2", "-o", "a.png"), ("--all", "-o", "a")):
                said = self.run_kfast("render", "scarce.kfb", *arguments, "-q").stderr
                self.assertEqual(said.count("\n"), 1, said)
                self.assertTrue(said.startswith(f"kfast: {says}, for outlines find no room"), said)
            for arguments in (("--frame", "0", "-o", "a.png"), ("--all", "-o", "a.svg")):
                self.assertEqual(self.run_kfast("render", "scarce.kfb", *arguments).stderr, "")


if __name__ == "__main__":
    unittest.main()
