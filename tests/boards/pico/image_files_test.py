"""Checks the files of the Pico's images, by rules of their own: image_files_test.py <folder of the build>"""

import pathlib
import struct
import sys
import unittest

BUILD = pathlib.Path(sys.argv[1])
IMAGES = ["pico-spi", "pico-i2c", "pico-parallel", "pico-xy"]

FLASH = 0x10000000
MARK = 0x1A8
PROGRAM_END = 0x3F000  # where the settings begin
RAM_END = 0x20042000
RP2040 = 0xE48BFF56
UF2_BLOCK = struct.Struct("<8I476sI")


def crc32_mpeg2(data):
    state = 0xFFFFFFFF
    for byte in data:
        state ^= byte << 24
        for _ in range(8):
            state = (state << 1 ^ (0x04C11DB7 if state >> 31 else 0)) & 0xFFFFFFFF
    return state


def written(uf2):
    """What the boot ROM would write, sector by sector: it erases one when a block number is a multiple of 16."""
    flash = {}
    total = len(uf2) // 512
    for number, fields in enumerate(UF2_BLOCK.iter_unpack(uf2)):
        assert fields[:3] == (0x0A324655, 0x9E5D5157, 0x2000) and fields[9] == 0x0AB16F30
        address, size, block, count, family, data = fields[3:9]
        assert (size, block, count, family) == (256, number, total, RP2040)
        sector, page = address // 4096, address % 4096 // 256
        assert page == block % 16
        if page == 0:
            assert sector not in flash
            flash[sector] = b""
        flash[sector] += data[:256]
    return flash


class ImageFiles(unittest.TestCase):
    def setUp(self):
        self.images = {name: (BUILD / f"{name}.bin").read_bytes() for name in IMAGES}

    def test_boot_blocks_have_their_checksum(self):
        for name, image in self.images.items():
            with self.subTest(name):
                self.assertEqual(struct.unpack("<I", image[252:256])[0], crc32_mpeg2(image[:252]))
                self.assertNotEqual(image[:16], bytes(16))

    def test_vectors_follow_the_boot_block(self):
        for name, image in self.images.items():
            with self.subTest(name):
                stack, *handlers = struct.unpack("<42I", image[256:256 + 42 * 4])
                self.assertEqual(stack, RAM_END)
                self.assertTrue(all(handler % 2 == 1 for handler in handlers), "Thumb code")
                self.assertTrue(FLASH < handlers[0] < FLASH + len(image), "begins in flash")
                self.assertTrue(all(handler >> 28 == 2 for handler in handlers[1:]), "goes on in RAM")

    def test_they_tell_their_bus_behind_the_vectors(self):
        for bus, image in enumerate(self.images.values()):
            self.assertEqual(image[MARK:MARK + 8], b"KFPI" + bytes([bus, 0, 0, 0]))

    def test_images_end_before_the_settings(self):
        for name, image in self.images.items():
            with self.subTest(name):
                self.assertLessEqual(len(image), PROGRAM_END)

    def test_uf2_writes_the_image(self):
        for name, image in self.images.items():
            with self.subTest(name):
                flash = written((BUILD / f"{name}.uf2").read_bytes())
                self.assertEqual(sorted(flash), list(flash))
                self.assertEqual(list(flash), list(range(FLASH // 4096, FLASH // 4096 + len(flash))))
                whole = b"".join(flash.values())
                self.assertEqual(whole, image + b"\xff" * (len(whole) - len(image)))
                self.assertLess(len(whole) - len(image), 4096)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
