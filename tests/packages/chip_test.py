"""The assembled library is compiled for a chip, as a core of Arduino does it, and linked with a sketch:
chip_test.py <arm-none-eabi-g++> [<-mcpu=…>]. Tells its size."""

import concurrent.futures
import os
import re
import subprocess
import sys
import unittest

from assembled import ROOT, STUBS, assembled, output_of, temporary_folder

CHIP = sys.argv.pop(2) if len(sys.argv) > 2 else "-mcpu=cortex-m0plus"
CXX = sys.argv.pop(1)
CC = CXX.replace("g++", "gcc")  # links without the C++ library, of which nothing is needed
FLAGS = [CHIP, "-mthumb", "-Os", "-ffunction-sections", "-fdata-sections", "-fno-exceptions", "-fno-rtti",
         "-fno-threadsafe-statics"]
PAGE = (ROOT / "docs/packages.md").read_text(encoding="utf-8")


class Chip(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = temporary_folder(cls)
        cls.library = assembled("arduino", cls.folder)

    def compile(self, source, target, standard, *more):
        output_of(CXX, *FLAGS, f"-std={standard}", "-Wall", "-I", self.library / "src", "-I", STUBS / "arduino", "-I", ROOT, *more,
                  "-c", source, "-o", target)
        return target

    def objects(self):
        sources = sorted((self.library / "src").rglob("*.cpp"))
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as threads:
            return list(threads.map(lambda source: self.compile(source, source.with_suffix(".o"), "gnu++2a"), sources))

    def test_it_is_linked_and_small(self):
        sketch = self.compile(self.library / "examples/eyes_tft_espi/eyes_tft_espi.ino", self.folder / "sketch.o", "gnu++11",
                              "-x", "c++", "-include", "Arduino.h")
        rest = self.compile(STUBS / "arduino/chip.cpp", self.folder / "rest.o", "gnu++11")
        program = self.folder / "program"
        output_of(CC, *FLAGS, "-specs=nano.specs", "-specs=nosys.specs", "-Wl,--gc-sections", sketch, rest, *self.objects(), "-o",
                  program)
        code, data, zeroed = map(int, output_of("arm-none-eabi-size", program, text=True).splitlines()[1].split()[:3])
        print(f"{CHIP}: {code + data} bytes of flash, {data + zeroed} of RAM")
        self.expect_as_documented(code + data, data + zeroed)
        header = (ROOT / "examples/library/robot_eyes.h").read_text(encoding="utf-8")
        [player] = re.findall(r"robot_eyes_block_bytes = (\d+)", header)
        self.assertIn(f"Of the RAM {int(player):,} bytes are the player", PAGE)
        symbols = output_of("arm-none-eabi-nm", program, text=True)
        self.assertNotRegex(symbols, r"(?m) (malloc|_Znwj|__aeabi_[fd]\w+)$")

    def expect_as_documented(self, *bytes_used):
        name = re.escape(CHIP.removeprefix("-mcpu=").replace("cortex-m0plus", "cortex-m0+"))
        told = re.search(rf"(?i)^\| {name} \| ([\d,]+) bytes \| ([\d,]+) bytes \|$", PAGE, re.MULTILINE)
        for used, figure in zip(bytes_used, told.groups()):
            documented = int(figure.replace(",", ""))
            self.assertLess(abs(used - documented), documented // 100, f"docs/packages.md tells {figure}")

    def test_an_older_language_is_refused_in_words(self):
        refused = subprocess.run([CXX, *FLAGS, "-std=gnu++17", "-I", self.library / "src", "-c",
                                  self.library / "src/core/player.cpp", "-o", self.folder / "none.o"], capture_output=True, text=True)
        self.assertNotEqual(0, refused.returncode)
        self.assertIn("-std=gnu++2a", refused.stderr)
        self.assertEqual(1, refused.stderr.count("error:"))


if __name__ == "__main__":
    unittest.main()
