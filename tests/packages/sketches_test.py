"""Sketches and the program for ESP-IDF draw what the command draws:
sketches_test.py <installed> <c++ compiler> <kfast>. They are compiled as frameworks compile them, in C++11 and later, against
stubs of theirs and the installed library."""

import pathlib
import subprocess
import sys
import unittest
import zlib

from assembled import ROOT, STUBS, assembled, output_of, temporary_folder

KFAST = sys.argv.pop(3)
CXX = sys.argv.pop(2)
INSTALLED = pathlib.Path(sys.argv.pop(1)).resolve()
LIBRARIES = [INSTALLED / "lib/libkfast.a", INSTALLED / "lib/libkfast_core.a"]
FRAME_BYTES = 2 * 240 * 240
STRICT = ["-Wall", "-Wextra", "-Werror"]


def hashes_drawn(*options):
    """What the command draws, every 0.1 s: each third frame."""
    return [line.split()[1] for line in output_of(KFAST, "hash", ROOT / "examples/robot-eyes.kfast", *options,
                                                  text=True).splitlines()[::3]]


def hashes_of(frames):
    return [f"{zlib.crc32(frames[at:at + FRAME_BYTES]):08x}" for at in range(0, len(frames), FRAME_BYTES)]


class Sketches(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = temporary_folder(cls)
        cls.library = assembled("arduino", cls.folder)
        cls.scene = hashes_drawn()

    def run_sketch(self, name, steps, standard="gnu++17"):
        """What the glass showed after each step, as hashes, and the lines that the sketch printed."""
        program = self.folder / f"{name}-{standard}"
        output_of(CXX, f"-std={standard}", *STRICT, "-I", self.library / "src", "-I", STUBS / "arduino", "-I", ROOT,
                  "-DSET_LOOP_TASK_STACK_SIZE(bytes)=int loop_stack() { return bytes; }",  # as the core for the ESP32 has it
                  "-x", "c++", "-include", "Arduino.h", self.library / "examples" / name / f"{name}.ino",
                  STUBS / "arduino/computer.cpp", "-x", "none", *LIBRARIES, "-o", program)
        ran = subprocess.run([program, str(steps)], check=True, capture_output=True, timeout=120)
        return hashes_of(ran.stdout), ran.stderr.decode().splitlines()

    def test_tft_espi_shows_the_scene_whatever_the_language(self):
        for standard in "gnu++11", "gnu++2a":
            self.assertEqual((self.scene[:30], []), self.run_sketch("eyes_tft_espi", 30, standard))

    def test_adafruit_gfx_shows_the_scene_and_tells_its_event(self):
        self.assertEqual((self.scene[:20], ["5 blinked"]), self.run_sketch("eyes_adafruit_gfx", 20))

    def test_m5_shows_the_scene(self):
        self.assertEqual((self.scene[:20], []), self.run_sketch("eyes_m5", 20))

    def test_a_button_plays_a_clip_and_then_the_scene_goes_on(self):
        clip = hashes_drawn("--clip", "blink")[:4]  # of 10 frames
        shown, _ = self.run_sketch("button_clip", 20)
        self.assertEqual(self.scene[:4] + clip + self.scene[:12], shown)

    def test_esp_idf_shows_the_scene_and_waits_for_its_pixels(self):
        component = assembled("esp-idf", self.folder / "idf")
        program = self.folder / "esp_idf"
        main = component / "examples/robot_eyes/main/robot_eyes_main.c"
        output_of("cc", "-std=gnu17", *STRICT, "-Wno-missing-field-initializers", "-I", component / "src", "-I", STUBS / "esp_idf",
                  main, STUBS / "esp_idf/computer.c", *LIBRARIES, "-o", program)
        frames = bytearray(output_of(program))
        frames[0::2], frames[1::2] = frames[1::2], frames[0::2]  # they have the high byte first
        self.assertEqual(self.scene[:20], hashes_of(bytes(frames)))


if __name__ == "__main__":
    unittest.main()
