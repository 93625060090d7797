"""What is in UF2 files: kfast uf2 info, kfast uf2 unpack."""

import json
import struct
import unittest

from command_case import CommandTest
from pretend_firmware import firmware
from uf2_blocks import FAMILY, SCENE, SETTINGS

FLASH = 0x10000000
RP2350 = 0xE48BFF59


def block(address, number, count, family=FAMILY, flags=0x2000, payload=bytes(256), end=0x0AB16F30):
    head = struct.pack("<8I", 0x0A324655, 0x9E5D5157, flags, address, len(payload), number, count, family)
    return head + payload.ljust(476, b"\0") + struct.pack("<I", end)


class Uf2Test(CommandTest):
    def file(self, name, *blocks):
        (self.folder / name).write_bytes(b"".join(blocks))
        return name

    def packed(self):
        """A file of firmware, settings and a scene; firmware and compiled scene."""
        image = firmware(10_000)
        (self.folder / "f.bin").write_bytes(image)
        scene = bytes(self.compiled())
        self.run_kfast("uf2", "pack", "--firmware", "f.bin", "--config", "pico-gc9a01", "--scene", "repeat.kfast",
                       "-o", "all.uf2")
        return image, scene

    def info(self, name):
        return json.loads(self.run_kfast("uf2", "info", name, "--json").stdout)


class InfoTest(Uf2Test):
    def test_what_is_of_kfast_is_known(self):
        self.packed()
        told = self.run_kfast("uf2", "info", "all.uf2").stdout
        for words in ("all.uf2: 80 blocks\n", "for RP2040 (0xe48bff56): 80 blocks, 20480 bytes\n",
                      "0x10000000  10000 bytes  firmware for displays on spi\n",
                      "0x1003f000  4096 bytes  settings of a display gc9a01, 240 x 240, on spi\n", "scene: ",
                      "10 frames, 1 object"):
            self.assertIn(words, told)

    def test_settings_of_a_beam(self):
        self.run_kfast("uf2", "pack", "--config", "pico-xy-galvo", "-o", "a.uf2")
        self.assertIn("0x1003f000  4096 bytes  settings of a beam, 30000 points a second, on dac\n",
                      self.run_kfast("uf2", "info", "a.uf2").stdout)

    def test_json(self):
        _, scene = self.packed()
        told = self.info("all.uf2")
        self.assertEqual((told["file"], told["blocks"], len(told["parts"])), ("all.uf2", 80, 1))
        part = told["parts"][0]
        self.assertEqual((part["family"], part["chips"], part["flags"], part["blocks"], part["bytes"]),
                         (FAMILY, "RP2040", ["family"], 80, 20480))
        self.assertEqual([(region["address"], region["bytes"]) for region in part["regions"]],
                         [(FLASH, 10_000), (SETTINGS, 4096), (SCENE, len(scene))])
        self.assertIn("settings of a display gc9a01", part["regions"][1]["holds"])

    def test_files_of_others(self):
        self.file("other.uf2", block(0x26000, 0, 2, 0xADA52840), block(0x27000, 1, 2, 0xADA52840))
        told = self.info("other.uf2")["parts"][0]
        self.assertEqual(told["chips"], "NRF52840")
        self.assertEqual(told["regions"], [{"address": 0x26000, "bytes": 256, "holds": None},
                                           {"address": 0x27000, "bytes": 256, "holds": None}])
        self.file("unknown.uf2", block(0, 0, 1, 77))
        self.assertIn("for 0x0000004d: 1 block, 256 bytes", self.run_kfast("uf2", "info", "unknown.uf2").stdout)
        self.file("silent.uf2", block(0, 0, 1, 77, flags=0x4000))
        self.assertIn("for unknown chips: 1 block, 256 bytes, checksum", self.run_kfast("uf2", "info", "silent.uf2").stdout)
        self.assertIsNone(self.info("silent.uf2")["parts"][0]["family"])

    def test_several_families(self):
        self.file("both.uf2", block(FLASH, 0, 1), block(FLASH, 0, 2, RP2350), block(FLASH + 256, 1, 2, RP2350))
        parts = self.info("both.uf2")["parts"]
        self.assertEqual([(part["chips"], part["blocks"]) for part in parts], [("RP2040", 1), ("RP2350-ARM-S", 2)])

    def test_every_wrong_block_is_told(self):
        self.file("wrong.uf2", block(FLASH, 0, 4), block(FLASH + 256, 1, 4, end=0), block(FLASH + 513, 2, 4),
                  block(FLASH, 3, 4), b"x" * 100)
        self.refuse("uf2", "info", "wrong.uf2", status=1, says=(
            "kfast: wrong.uf2: 4 mistakes in 4 blocks: copy the file again, or make it again\n"
            "  block 1: it does not begin and end as a block of a UF2 file\n"
            "  block 2: its address 0x10000201 is no multiple of 256\n"
            "  block 3: it writes to 0x10000000, as block 0 has done before\n"
            "  block 4: the file ends after 100 of its 512 bytes: it was cut off, or is no UF2 file\n"))

    def test_a_long_list_is_cut(self):
        self.file("wrong.uf2", *(block(FLASH + 1 + 256 * number, number, 300) for number in range(300)))
        self.refuse("uf2", "info", "wrong.uf2", status=1, says="  block 19: its address 0x10001301 is no multiple of 256\n"
                    "  and 280 more\n")

    def test_files_that_are_none(self):
        self.refuse("uf2", "info", "once.kfast", status=1, says="block 0: ")
        self.refuse("uf2", "info", "none.uf2", status=1, says="none.uf2")
        self.file("empty.uf2")
        self.refuse("uf2", "info", "empty.uf2", status=1, says="empty")
        self.refuse("uf2", "info", status=2, says="FILE is required")


class UnpackTest(Uf2Test):
    def unpacked(self):
        return {path.name: path.read_bytes() for path in (self.folder / "out").iterdir()}

    def test_what_was_packed_comes_out(self):
        image, scene = self.packed()
        self.run_kfast("config", "pico-gc9a01", "-o", "c.bin")
        told = self.run_kfast("uf2", "unpack", "all.uf2", "-o", "out").stdout
        files = self.unpacked()
        self.assertEqual(sorted(files), ["all-10000000.bin", "all-1003f000.bin", "all-10040000.bin"])
        self.assertEqual(files["all-10000000.bin"], image)
        self.assertEqual(files["all-1003f000.bin"], (self.folder / "c.bin").read_bytes())
        self.assertEqual(files["all-10040000.bin"], scene)
        self.assertIn("out/all-1003f000.bin: 4096 bytes, settings of a display gc9a01", told)
        self.run_kfast("uf2", "unpack", "all.uf2", "-o", "out")
        self.assertEqual(self.unpacked(), files)

    def test_a_program_that_does_not_tell_its_length_keeps_the_padding(self):
        image = firmware(5000, mark=bytes(8))
        (self.folder / "f.bin").write_bytes(image)
        self.run_kfast("uf2", "pack", "--firmware", "f.bin", "-o", "f.uf2")
        self.assertIn("0x10000000  8192 bytes  a program that begins with a boot block\n",
                      self.run_kfast("uf2", "info", "f.uf2").stdout)
        self.run_kfast("uf2", "unpack", "f.uf2", "-o", "out")
        self.assertEqual(self.unpacked(), {"f-10000000.bin": image + b"\xff" * (8192 - 5000)})

    def test_a_family_is_chosen(self):
        self.file("both.uf2", block(FLASH, 0, 1, payload=b"a" * 256), block(FLASH, 0, 1, RP2350, payload=b"b" * 256))
        self.refuse("uf2", "unpack", "both.uf2", "-o", "out", status=2,
                    says="choose one with --family\n  RP2040 (0xe48bff56)\n  RP2350-ARM-S (0xe48bff59)\n")
        for name, content in (("rp2040", b"a"), ("rp2350-arm-s", b"b"), ("0xe48bff56", b"a")):
            self.run_kfast("uf2", "unpack", "both.uf2", "--family", name, "-o", "out")
            self.assertEqual(self.unpacked(), {"both-10000000.bin": content * 256})
        self.refuse("uf2", "unpack", "both.uf2", "--family", "esp32", "-o", "none", status=1, says="has nothing for esp32, but for")
        self.refuse("uf2", "unpack", "both.uf2", "--family", "pico", "-o", "none", status=2, says="neither the name of a family")

    def test_the_file_itself_is_not_overwritten(self):
        self.file("a-10000000.bin", block(FLASH, 0, 1))
        (self.folder / "out").mkdir()
        (self.folder / "out" / "a-10000000.bin").hardlink_to(self.folder / "a-10000000.bin")
        (self.folder / "a.uf2").hardlink_to(self.folder / "a-10000000.bin")
        before = (self.folder / "a.uf2").read_bytes()
        self.refuse("uf2", "unpack", "a.uf2", "-o", "out", status=1, says="this would overwrite the file itself")
        self.assertEqual((self.folder / "a.uf2").read_bytes(), before)

    def test_what_is_wrong_is_not_unpacked(self):
        self.file("wrong.uf2", block(FLASH, 0, 2))
        self.refuse("uf2", "unpack", "wrong.uf2", "-o", "out", status=1, says="there are 2 blocks for its chips, but there are 1")
        self.file("right.uf2", block(FLASH, 0, 1))
        self.refuse("uf2", "unpack", "right.uf2", "-o", "once.kfast", status=1, says="cannot make the folder once.kfast")
        self.refuse("uf2", "unpack", "right.uf2", status=2, says="--output is required")


if __name__ == "__main__":
    unittest.main()
