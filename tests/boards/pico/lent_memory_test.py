"""Checks that kfast fit --board pico and pico-xy speaks of the memory that the images have: lent_memory_test.py <folder
of the build> <kfast>"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

BUILD = pathlib.Path(sys.argv[1])
KFAST = pathlib.Path(sys.argv[2]).resolve()
UNUSED = 4096  # that fit may leave of the block: the images grow and shrink a little with every change

SCENE = "kfast 1\ncanvas 240 240\nobject dot fill=white { rect 0 0 9 9 }\n"


def symbols(image):
    """name -> (address, size)"""
    listing = subprocess.run(["arm-none-eabi-nm", "--format=posix", "--radix=d", BUILD / f"{image}.elf"],
                             check=True, stdout=subprocess.PIPE, text=True, timeout=60).stdout
    plain = re.sub(r"\.lto_priv\.\d+ ", " ", listing)  # which the linker appends now and then
    readable = subprocess.run(["arm-none-eabi-c++filt"], input=plain, check=True, stdout=subprocess.PIPE, text=True,
                              timeout=60).stdout
    found = {}
    for line in readable.splitlines():
        name, _, address, size = line.rsplit(" ", 3)
        found[name.split("::")[-1]] = int(address), int(size or 0)
    return found


def fit_report(board):
    with tempfile.TemporaryDirectory(prefix="kfast") as folder:
        scene = pathlib.Path(folder, "dot.kfast")
        scene.write_text(SCENE)
        told = subprocess.run([KFAST, "fit", scene, "--board", board, "--json"], check=True, stdout=subprocess.PIPE,
                              text=True, timeout=60)
    return json.loads(told.stdout)


class LentMemory:
    def setUp(self):
        self.fit = fit_report(self.board)
        self.images = {image: symbols(image) for image in self.image_names}

    def between(self, name):
        return [image[f"{name}_end"][0] - image[f"{name}_begin"][0] for image in self.images.values()]

    def test_room_of_the_block(self):
        ram = self.fit["ram"]
        room = ram["available"] - ram["used"] + ram["block"]
        lent = min(self.between("player_block"))
        self.assertLessEqual(room, lent, f"what fits must find room: more ram= of host/fit/boards/{self.board}.kdl")
        self.assertGreater(room, lent - UNUSED, f"less ram= of host/fit/boards/{self.board}.kdl will do")

    def test_buffers(self):
        for image in self.images.values():
            # Linking as a whole may decorate the names of what only one file knows.
            sizes = [size for name, (_, size) in image.items() if re.fullmatch(rf"{self.buffers}(\.\w+)*", name)]
            self.assertEqual(sizes, [self.fit["ram"][self.buffers_field] + self.beside_buffers])

    def test_room_of_the_scene(self):
        flash = self.fit["flash"]
        room = flash["available"] - flash["used"] + flash["scene"]
        self.assertEqual(self.between("scene_region"), [room] * len(self.images))


class LentMemoryOfPanels(LentMemory, unittest.TestCase):
    board = "pico"
    image_names = ("pico-spi", "pico-i2c", "pico-parallel")
    buffers = "band_buffers"
    buffers_field = "bands"
    beside_buffers = 0


class LentMemoryOfBeam(LentMemory, unittest.TestCase):
    board = "pico-xy"
    image_names = ("pico-xy",)
    buffers = "pictures"
    buffers_field = "buffers"
    beside_buffers = 2 * 8  # how many points each has, and where they are


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
