"""What a flash is to hold, in one file: kfast uf2 pack."""

import re
import unittest

from command_case import CommandTest
from gadget import GADGET
from pretend_firmware import MARK, firmware
from uf2_blocks import SCENE, SETTINGS, memory

STEERED = """kfast 1
canvas 60 40
input gaze min=-1 max=1
input "wide open" min=0 max=1
group g {
    track x input=gaze { at -1 0; at 1 9 }
    track y input="wide open" { at 0 0; at 1 9 }
    object dot fill=white { rect 1 1 14 14 }
}
"""
# More bytes than there is room for, in names: they take no time to compile.
LARGE = "kfast 1\ncanvas 240 240 frames=700\nobject o fill=white { rect 0 0 9 9 }\n" + "".join(
    f'event {event % 700} "{event:0250}"\n' for event in range(1100))


class PackTest(CommandTest):
    def pack(self, *arguments):
        self.run_kfast("uf2", "pack", *arguments, "-o", "a.uf2")
        return memory((self.folder / "a.uf2").read_bytes())

    def firmware(self, size):
        (self.folder / "f.bin").write_bytes(firmware(size))
        return "--firmware", "f.bin"

    def test_everything_has_its_place(self):
        scene = bytes(self.compiled())
        self.run_kfast("config", "pico-gc9a01", "-o", "c.bin")
        sectors = self.pack(*self.firmware(10_000), "--config", "pico-gc9a01", "--scene", "repeat.kfast")
        self.assertEqual(list(sectors), [0x10000000, 0x10001000, 0x10002000, SETTINGS, SCENE])
        image = b"".join(sectors[address] for address in (0x10000000, 0x10001000, 0x10002000))
        self.assertEqual(image, firmware(10_000) + b"\xff" * (3 * 4096 - 10_000))
        self.assertEqual(sectors[SETTINGS], (self.folder / "c.bin").read_bytes())
        self.assertEqual(sectors[SCENE], scene + b"\xff" * (4096 - len(scene)))

    def test_each_alone(self):
        self.assertEqual(list(self.pack(*self.firmware(500))), [0x10000000])
        self.assertEqual(list(self.pack("--config", "pico-st7789")), [SETTINGS])
        self.assertEqual(list(self.pack("--scene", "once.kfast")), [SCENE])

    def test_a_compiled_scene_is_packed_as_it_is(self):
        text = self.pack("--scene", "repeat.kfast")
        self.compiled()
        self.assertEqual(self.pack("--scene", "repeat.kfb"), text)

    def test_it_tells_what_is_in_it_and_what_to_do(self):
        told = self.run_kfast("uf2", "pack", "--config", "pico-st7789", "--scene", "once.kfast", "-o", "a.uf2").stdout
        self.assertRegex(told, r"^a\.uf2: settings of pico-st7789, scene of \d+ bytes\nHold BOOTSEL")

    def test_firmware_for_another_bus_is_refused(self):
        for number, bus, other, name in ((0, "spi", "i2c", "pico-ssd1306-i2c"), (1, "i2c", "parallel", "pico-ili9341-parallel"),
                                         (2, "parallel", "spi", "pico-gc9a01")):
            (self.folder / "f.bin").write_bytes(firmware(8192, b"KFPI" + bytes([number, 0, 0, 0])))
            self.refuse("uf2", "pack", "--firmware", "f.bin", "--config", name, "-o", "b.uf2", status=1,
                        says=f"f.bin: firmware for displays on {bus}, but the display of {name} is on {other}: "
                        f"take build/pico/pico-{other}.bin")

    def test_firmware_for_the_bus_is_taken(self):
        for number, name in enumerate(("pico-st7789", "pico-ssd1306-i2c", "pico-ili9341-parallel")):
            (self.folder / "f.bin").write_bytes(firmware(8192, b"KFPI" + bytes([number, 0, 0, 0])))
            told = self.run_kfast("uf2", "pack", "--firmware", "f.bin", "--config", name, "-o", "a.uf2")
            self.assertEqual(told.stderr, "")

    def test_firmware_that_is_not_whole_is_refused(self):
        for image, says in ((firmware(8192)[:8191], "f.bin: 8191 bytes instead of 8192: it was cut off, or an older"),
                            (firmware(8192) + b"\n", "f.bin: 8193 bytes instead of 8192"),
                            (firmware(8192)[:MARK + 10], f"f.bin: only {MARK + 10} bytes: it was cut off")):
            (self.folder / "f.bin").write_bytes(image)
            self.refuse("uf2", "pack", "--firmware", "f.bin", "-o", "b.uf2", status=1, says=says)

    def test_firmware_without_a_mark_is_warned_of(self):
        for image in (firmware(8192, b""), firmware(8192, b"KFPI\4"), firmware(8192, b"KFPJ\0")):
            (self.folder / "f.bin").write_bytes(image)
            told = self.run_kfast("uf2", "pack", "--firmware", "f.bin", "--config", "pico-ssd1306-i2c", "-o", "a.uf2")
            self.assertRegex(told.stderr, r"^f\.bin: warning: .* for i2c: build/pico/pico-i2c\.bin\n$")
        self.assertEqual(self.run_kfast("uf2", "pack", "--firmware", "f.bin", "-o", "a.uf2").stderr, "")

    def test_the_example_of_the_help_names_an_image_that_there_is(self):
        told = self.run_kfast("uf2", "pack", "--help").stdout
        self.assertIn("kfast uf2 pack --firmware build/pico/pico-spi.bin --config pico-st7789", told)

    def test_clips_that_the_scene_does_not_have_are_warned_of(self):
        (self.folder / "g.kdl").write_text(GADGET.replace("clip idle", "clip sway; knob 26 place doze; button 13 play doze"))
        told = self.run_kfast("uf2", "pack", "--config", "g.kdl", "--scene", "marked.kfast", "-o", "a.uf2")
        self.assertEqual(told.stderr, 'g.kdl: warning: marked.kfast: there is no clip "doze", the whole scene will play in its '
                                      'place: allowed: blink, sway\n')
        told = self.run_kfast("uf2", "pack", "--config", "g.kdl", "--scene", "once.kfast", "-o", "a.uf2")
        self.assertEqual([re.search(r'no clip "(\w+)"', line)[1] for line in told.stderr.splitlines()], ["blink", "doze", "sway"])
        self.assertEqual(told.stderr.count("the scene has no clips"), 3)

    def test_inputs_that_the_scene_does_not_have_are_warned_of(self):
        (self.folder / "steered.kfast").write_text(STEERED)
        (self.folder / "g.kdl").write_text(GADGET.replace(
            "clip idle", 'knob 26 input gase; knob 27 input gaze; button 13 input "wide open"; button 14 input gase')
            .replace("button 12 play blink", "button 12 input shut"))
        told = self.run_kfast("uf2", "pack", "--config", "g.kdl", "--scene", "steered.kfast", "-o", "a.uf2")
        nothing = 'its button or knob will do nothing: '
        self.assertEqual(told.stderr,
                         f'g.kdl: warning: steered.kfast: there is no input "gase", {nothing}did you mean "gaze"?\n'
                         f'g.kdl: warning: steered.kfast: there is no input "shut", {nothing}allowed: gaze, wide open\n')
        told = self.run_kfast("uf2", "pack", "--config", "g.kdl", "--scene", "once.kfast", "-o", "a.uf2")
        self.assertEqual(told.stderr.count(f"{nothing}the scene has no inputs\n"), 4)

    def test_clips_that_the_scene_is_near_to_are_named(self):
        (self.folder / "g.kdl").write_text(GADGET.replace("clip idle", "clip swya"))
        told = self.run_kfast("uf2", "pack", "--config", "g.kdl", "--scene", "marked.kfast", "-o", "a.uf2")
        self.assertIn('no clip "swya", the whole scene will play in its place: did you mean "sway"?', told.stderr)

    def test_clips_that_the_scene_has_need_no_words(self):
        (self.folder / "g.kdl").write_text(GADGET.replace("clip idle", "clip sway; button 13 play; button 14 pause"))
        told = self.run_kfast("uf2", "pack", "--config", "g.kdl", "--scene", "marked.kfast", "-o", "a.uf2")
        self.assertEqual(told.stderr, "")

    def test_what_is_too_large(self):
        self.pack(*self.firmware(0x3F000))
        self.refuse("uf2", "pack", *self.firmware(0x3F001), "-o", "b.uf2", status=7, says="1 more than lie before the settings")
        (self.folder / "large.kfast").write_text(LARGE)
        self.run_kfast("compile", "large.kfast")
        excess = (self.folder / "large.kfb").stat().st_size - 0x40000
        self.assertGreater(excess, 0)
        self.refuse("uf2", "pack", "--scene", "large.kfb", "-o", "b.uf2", status=7,
                    says=f"{excess} more than a Pico has room for as its built-in scene")

    def test_wrong_inputs(self):
        self.refuse("uf2", status=2, says="a command is missing: allowed: pack")
        self.refuse("uf2", "pakc", status=2, says="there is no command 'pakc': did you mean \"pack\"?")
        self.refuse("uf2", "pack", "extra", "-o", "a.uf2", status=2, says="not expected: extra")
        self.refuse("uf2", "--frobnicate", "pack", "--scene", "once.kfast", "-o", "a.uf2", status=2, says="--frobnicate")
        self.refuse("uf2", "pack", "-o", "a.uf2", status=2, says="one of --firmware, --config and --scene is required")
        self.refuse("uf2", "pack", "--scene", "once.kfast", status=2, says="Try 'kfast uf2 pack --help'")
        self.refuse("uf2", "pack", "--config", "pico-st7798", "-o", "a.uf2", status=1, says='did you mean "pico-st7789"?')
        self.refuse("uf2", "pack", "--scene", "none.kfast", "-o", "a.uf2", status=1, says="none.kfast: there is no such file")
        for output in ("x.txt", "once.kfast", "x", "x.UF2", "uf2"):
            self.refuse("uf2", "pack", "--scene", "once.kfast", "-o", output, status=2, says=f"'{output}': the drive of a Pico takes .uf2")
        (self.folder / "once.uf2").write_text((self.folder / "once.kfast").read_text())
        self.refuse("uf2", "pack", "--scene", "once.uf2", "-o", "once.uf2", status=1, says="overwrite the file that is read")
        self.refuse("uf2", "pack", "--scene", "once.kfast", "-o", "none/a.uf2", status=1, says="create the folder first")
        image = firmware(4096)
        for content in (image[:200], image[:100] + b"x" + image[101:], b"\x7fELF" + image):
            (self.folder / "f.bin").write_bytes(content)
            self.refuse("uf2", "pack", "--firmware", "f.bin", "-o", "a.uf2", status=1, says="f.bin: does not begin with a boot block")

    def test_a_full_disk_leaves_what_was_there(self):
        (self.folder / "a.uf2").write_text("before")
        self.refuse("uf2", "pack", "--scene", "once.kfast", "-o", "a.uf2", status=1, says="a.uf2", limit=1000)
        self.assertEqual((self.folder / "a.uf2").read_text(), "before")


if __name__ == "__main__":
    unittest.main()
