"""Checks that kfast fit --board pico speaks of the memory that the images have: lent_memory_test.py <folder of the
build> <kfast>"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

BUILD = pathlib.Path(sys.argv[1])
KFAST = pathlib.Path(sys.argv[2]).resolve()
IMAGES = ["pico-spi", "pico-i2c", "pico-parallel"]
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


def fit_report():
    with tempfile.TemporaryDirectory(prefix="kfast") as folder:
        scene = pathlib.Path(folder, "dot.kfast")
        scene.write_text(SCENE)
        told = subprocess.run([KFAST, "fit", scene, "--board", "pico", "--json"], check=True, stdout=subprocess.PIPE,
                              text=True, timeout=60)
    return json.loads(told.stdout)


class LentMemory(unittest.TestCase):
    def setUp(self):
        self.fit = fit_report()
        self.images = {image: symbols(image) for image in IMAGES}

    def between(self, name):
        return [image[f"{name}_end"][0] - image[f"{name}_begin"][0] for image in self.images.values()]

    def test_room_of_the_block(self):
        ram = self.fit["ram"]
        room = ram["available"] - ram["used"] + ram["block"]
        lent = min(self.between("player_block"))
        self.assertLessEqual(room, lent, "what fits must find room: more ram= of host/fit/boards/pico.kdl")
        self.assertGreater(room, lent - UNUSED, "less ram= of host/fit/boards/pico.kdl will do")

    def test_bands(self):
        for image in self.images.values():
            # Linking as a whole may decorate the names of what only one file knows.
            sizes = [size for name, (_, size) in image.items() if "band_buffers" in name]
            self.assertEqual(sizes, [self.fit["ram"]["bands"]])

    def test_room_of_the_scene(self):
        flash = self.fit["flash"]
        room = flash["available"] - flash["used"] + flash["scene"]
        self.assertEqual(self.between("scene_region"), [room] * len(IMAGES))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
