"""The pictures on a panel from what an emulator saw on its wires: panel_test.py <kfast-panel>."""

import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

from PIL import Image

KFAST_PANEL = pathlib.Path(sys.argv.pop(1)).resolve()

LOW, HIGH, RESET_LOW, RESET_HIGH, SELECTED, DESELECTED, NOTE = range(7)
MS = 1_000_000


def record(kind, time, content=b""):
    return struct.pack("<BQI", kind, time, len(content)) + content


def board_record(controller, rotation, flags, width, height, column, row):
    fields = struct.pack("<BBBBHHHH", controller, rotation, flags, 255, width, height, column, row)
    fields += bytes([0, 0x3C]) + b"\xff" * 8 + struct.pack("<I", 1000) + bytes(24) + bytes(8 * 28)
    body = b"KFBS" + struct.pack("<HH", 1, len(fields)) + fields
    return body + struct.pack("<I", zlib.crc32(body))


def command(time, code, *parameters):
    return record(LOW, time, bytes([code])) + (record(HIGH, time, bytes(parameters)) if parameters else b"")


def start_up():
    return (record(RESET_LOW, 0) + record(RESET_HIGH, MS) + record(SELECTED, MS) + command(121 * MS, 0x11)
            + command(241 * MS, 0x36, 0x60) + command(241 * MS, 0x3A, 0x05) + command(241 * MS, 0x29))


def picture(time, *colours):
    """On a glass of 3 x 2 at (2, 1) that is turned by a quarter: 2 x 3 pixels are seen."""
    pixels = b"".join(struct.pack(">H", colour) for colour in colours)
    return (command(time, 0x2A, 0, 1, 0, 2) + command(time, 0x2B, 0, 127, 0, 129) + command(time, 0x2C)
            + record(HIGH, time, pixels))


COLOURS = (0xF800, 0x07E0, 0x001F, 0xFFFF, 0x0000, 0x8410)
SEEN = ((255, 0, 0), (0, 255, 0), (0, 0, 255), (255, 255, 255), (0, 0, 0), (132, 130, 132))


class PanelTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="kfast")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        (self.folder / "record").write_bytes(board_record(2, 1, 0, 3, 2, 2, 1) + b"\xff" * 100)

    def replay(self, trace, *more, status=0):
        (self.folder / "trace").write_bytes(b"KFTRACE1" + trace)
        result = subprocess.run([KFAST_PANEL, "trace", "record", *more], cwd=self.folder, capture_output=True, text=True,
                                timeout=60)
        self.assertEqual(result.returncode, status, result.stdout + result.stderr)
        return result

    def crc(self, *colours):
        return f"{zlib.crc32(struct.pack('<6H', *colours)):08x}"

    def test_notes_are_told_and_frames_have_the_hash_of_what_is_seen(self):
        trace = (record(NOTE, 0, b"kfast 0.1.0") + start_up() + picture(250 * MS, *COLOURS) + record(NOTE, 251 * MS, b"F 0")
                 + picture(252 * MS, *COLOURS[::-1]) + record(NOTE, 253 * MS, b"F 1 late") + record(NOTE, 254 * MS, b"Fin"))
        lines = self.replay(trace).stdout.splitlines()
        self.assertEqual(lines, ["kfast 0.1.0", f"F 0 {self.crc(*COLOURS)}", f"F 1 late {self.crc(*COLOURS[::-1])}", "Fin"])

    def test_pictures_are_written_as_they_are_seen(self):
        trace = start_up() + record(NOTE, 242 * MS, b"F 0") + picture(250 * MS, *COLOURS) + record(NOTE, 251 * MS, b"F 1")
        self.replay(trace, "--pictures", "shots/now")
        self.assertEqual(sorted(path.name for path in (self.folder / "shots/now").iterdir()), ["0000.png", "0001.png"])
        with Image.open(self.folder / "shots/now/0000.png") as image:
            self.assertEqual(list(image.getdata()), [(0, 0, 0)] * 6)
        with Image.open(self.folder / "shots/now/0001.png") as image:
            self.assertEqual(image.size, (2, 3))
            self.assertEqual(tuple(image.getdata()), SEEN)

    def test_a_mistake_of_the_bus_ends_it(self):
        result = self.replay(record(NOTE, 0, b"hello") + record(SELECTED, 0) + command(6 * MS, 0x11), status=1)
        self.assertEqual(result.stdout, "hello\n")
        self.assertIn("byte 0 at 6.000 ms: command 0x11 too soon", result.stderr)

    def test_damage_is_told_with_its_place(self):
        result = self.replay(record(NOTE, 0, b"hello") + b"\x09", status=1)
        self.assertIn("damaged at byte 26", result.stderr)
        self.assertEqual(result.stdout, "")

    def test_a_record_must_describe_a_panel(self):
        (self.folder / "record").write_bytes(b"\xff" * 4096)
        self.assertIn("record: is no board record", self.replay(b"", status=1).stderr)
        (self.folder / "record").write_bytes(board_record(2, 0, 0, 128, 160, 5, 1))
        self.assertIn("a glass of 128x160 at column 5, row 1", self.replay(b"", status=1).stderr)

    def test_usage(self):
        for arguments in (("--pictures",), ("--picture", "x"), ("--pictures", "x", "y")):
            self.assertIn("usage: kfast-panel", self.replay(b"", *arguments, status=2).stderr)
        self.assertIn("cannot be read", subprocess.run([KFAST_PANEL, "none", "record"], cwd=self.folder,
                                                       capture_output=True, text=True, timeout=60).stderr)


if __name__ == "__main__":
    unittest.main()
