"""Settings of boards: kfast config, kfast wiring, kfast uf2 pack."""

import json
import re
import struct
import unittest
import zlib

from command_case import ROOT, CommandTest
from pretend_firmware import MARK, firmware

READY = ["pico-st7789", "pico-ili9341", "pico-gc9a01", "pico-ssd1306", "pico-ssd1306-i2c", "pico-ili9341-parallel",
         "pico-xy-scope", "pico-xy-galvo"]
SETTINGS = 0x1003F000
SCENE = 0x10040000
FAMILY = 0xE48BFF56

GADGET = """board pico {
    panel st7789 135 240 column=52 row=40 rotation=90
    bus spi clock=(MHz)62.5
    pins clock=18 data=19 dc=16
    clip idle
    button 12 play blink
}
"""
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
WRONG = """board pico {
    panel st7789 240 400
    bus spi clock=(MHz)99
    pins clock=18 data=19 dc=18
}
"""
BROKEN = """board pico {
    panel st7788
    bus spi clock=62.5
    pins sck=18
    knob twelve play
}
"""

# More than a Pico has room for: letters of many points, other ones in each key.
# More bytes than there is room for, in names: they take no time to compile.
LARGE = "kfast 1\ncanvas 240 240 frames=700\nobject o fill=white { rect 0 0 9 9 }\n" + "".join(
    f'event {event % 700} "{event:0250}"\n' for event in range(1100))


def blocks(uf2):
    """(address, payload) of each block, whose fields are checked on the way."""
    assert len(uf2) % 512 == 0
    count = len(uf2) // 512
    for number in range(count):
        block = uf2[512 * number:512 * (number + 1)]
        first, second, flags, address, size, its_number, its_count, family = struct.unpack_from("<8I", block)
        assert (first, second, block[508:]) == (0x0A324655, 0x9E5D5157, struct.pack("<I", 0x0AB16F30))
        assert (flags, size, its_number, its_count, family) == (0x2000, 256, number, count, FAMILY)
        yield address, block[32:288]


def memory(uf2):
    """What lies where: address of each sector -> bytes."""
    sectors = {}
    for address, payload in blocks(uf2):
        sectors.setdefault(address // 4096 * 4096, bytearray()).extend(payload)
    return sectors


class ConfigTest(CommandTest):
    def setUp(self):
        super().setUp()
        for name, text in (("gadget", GADGET), ("wrong", WRONG), ("broken", BROKEN)):
            self.file(f"{name}.kdl").write_text(text)

    def file(self, name):
        return self.folder / name

    def text(self, name, **more):
        return self.run_kfast("config", name, **more).stdout

    def written(self, name, output):
        self.run_kfast("config", name, "-o", output)
        return self.file(output).read_bytes()

    def test_the_ready_configurations_are_named_and_can_be_used(self):
        listed = self.run_kfast("config", "--list").stdout.splitlines()
        self.assertEqual([line.split()[0] for line in listed[::2]], READY)
        self.assertTrue(all(len(line.split()) > 5 for line in listed[::2]), "each is described")
        buses = ["spi"] * 4 + ["i2c", "parallel", "xy", "xy"]
        self.assertEqual([line.strip() for line in listed[1::2]],
                         [f"firmware: build/pico/pico-{bus}.bin" for bus in buses])
        for name in READY:
            told = self.run_kfast("config", name)
            self.assertEqual(told.stderr, "", "nothing to worry about")
            self.assertTrue(told.stdout.startswith("board pico {\n"))

    def test_a_text_is_completed(self):
        told = self.text("gadget.kdl")
        for part in ("panel st7789 135 240 column=52 row=40 rotation=90 colours=rgb inverted=#true brightness=1",
                     "the picture on it is 240 x 135", "bus spi clock=(MHz)62.5", "pins clock=18 data=19 dc=16\n", "clip idle\n",
                     "button 12 play blink\n"):
            self.assertIn(part, told)

    def test_all_forms_hold_the_same(self):
        for name in [*READY, "gadget.kdl"]:
            told = self.text(name)
            self.written(name, "a.kdl")
            self.assertEqual(self.file("a.kdl").read_text(), told)
            for output in ("b.bin", "c.uf2"):
                self.written("a.kdl", output)
                self.assertEqual(self.text(output), told)

    def test_the_sector(self):
        sector = self.written("gadget.kdl", "a.bin")
        self.assertEqual(len(sector), 4096)
        self.assertEqual(sector[:6], b"KFBS\1\0")
        end = 8 + struct.unpack_from("<H", sector, 6)[0]
        self.assertEqual(struct.unpack_from("<I", sector, end)[0], zlib.crc32(sector[:end]))
        self.assertEqual(sector[end + 4:], b"\xff" * (4096 - end - 4))
        self.assertEqual(memory(self.written("gadget.kdl", "a.uf2")), {SETTINGS: sector})

    def test_records_are_found_whatever_they_lie_in(self):
        sector = self.written("gadget.kdl", "a.bin")
        told = self.text("gadget.kdl")
        self.file("record").write_bytes(sector[:300])
        self.file("flash.dump").write_bytes(b"\xff" * 0x3F000 + sector + bytes(0x1000))
        for name in ("./record", "flash.dump"):
            self.assertEqual(self.text(name), told)
        self.file("f.bin").write_bytes(firmware(0x3F000))  # up to the settings
        self.run_kfast("uf2", "pack", "--firmware", "f.bin", "--config", "a.bin", "--scene", "once.kfast", "-o", "all.uf2")
        self.assertEqual(self.text("all.uf2"), told)

    def test_a_clock_above_the_rating_is_warned_of(self):
        self.file("fast.kdl").write_text(GADGET.replace("st7789 135 240 column=52 row=40", "ili9341"))
        told = self.run_kfast("config", "fast.kdl", "-o", "a.bin")
        self.assertIn("fast.kdl:3:13: warning: faster than the maker of ili9341 allows, (MHz)10", told.stderr)
        self.assertTrue(self.file("a.bin").exists())

    def test_several_mistakes_are_told_at_once_and_nothing_is_written(self):
        for command in (("config", "wrong.kdl"), ("config", "wrong.kdl", "-o", "a.bin"), ("wiring", "wrong.kdl"),
                        ("uf2", "pack", "--config", "wrong.kdl", "-o", "a.uf2")):
            self.refuse(*command, status=1, says="wrong.kdl:2:18: error: a glass of 240 x 400")
            self.refuse(*command, status=1, says="wrong.kdl:3:13: error: a Pico has no spi that is so fast")
            self.refuse(*command, status=1, says="wrong.kdl:4:27: error: GP18 is taken twice")
            self.refuse(*command, status=1, says="kfast: wrong.kdl: 3 errors")
        for says in ('broken.kdl:2:11: error: unknown value "st7788"', 'did you mean "st7789"?', "3:19: error: a frequency needs",
                     "4:10: error", "here it is called clock", "5:10: error", "5:17: error: play is not for a knob"):
            self.refuse("config", "broken.kdl", "-o", "a.kdl", status=1, says=says)

    def test_rules_are_looked_at_when_every_line_can_be_read(self):
        self.file("both.kdl").write_text(WRONG.replace("dc=18", "dc=18 sck=1"))
        told = self.run_kfast("config", "both.kdl", status=1).stderr
        self.assertIn("here it is called clock", told)
        self.assertIn("kfast: both.kdl: 1 error\n", told)

    def test_one_mistake_of_each_rule_is_told(self):
        self.file("shared.kdl").write_text(GADGET.replace("dc=16", "dc=18 reset=19"))
        told = self.run_kfast("config", "shared.kdl", status=1).stderr
        self.assertEqual(told.count(" is taken twice"), 1)

    def test_wrong_inputs(self):
        self.refuse("config", status=2, says="kfast config --list")
        self.refuse("config", "pico-st7798", status=1, says='did you mean "pico-st7789"?')
        self.refuse("config", "pico", status=1, says="or name a file, like gadget.kdl")
        self.refuse("config", "none.kdl", status=1, says="none.kdl: there is no such file")
        self.refuse("config", ".", status=1, says="name a .kdl, .bin or .uf2 file in it")
        self.refuse("config", "once.kfast", status=1, says="once.kfast:1:1: error: a text of settings is one node")
        self.refuse("config", "--list", "pico-st7789", status=2, says="--list")
        self.refuse("config", "--list", "-o", "a.kdl", status=2, says="--list")

    def test_inputs_that_hold_no_settings(self):
        for name, content, says in (
                ("empty.bin", b"", "settings begin with 'board pico'"),
                ("zeros.bin", bytes(4096), "there are no settings in it"),
                ("erased.bin", b"\xff" * 0x80000, "there are no settings in it"),
                ("short.uf2", b"UF2\n" + bytes(100), "not a UF2 file for a Pico: a UF2 file is made of blocks of 512 bytes")):
            self.file(name).write_bytes(content)
            self.refuse("config", name, status=1, says=f"{name}: ")
            self.refuse("config", name, status=1, says=says)
        self.run_kfast("uf2", "pack", "--scene", "once.kfast", "-o", "scene.uf2")
        self.refuse("wiring", "scene.uf2", status=1, says="there are no settings in it")

    def test_damaged_records(self):
        sector = self.written("gadget.kdl", "a.bin")
        self.file("cut.bin").write_bytes(sector[:100])
        self.file("bit.bin").write_bytes(sector[:20] + bytes([sector[20] ^ 1]) + sector[21:])
        for name in ("cut.bin", "bit.bin"):
            self.refuse("config", name, status=1, says=f"{name}: the settings in it are damaged")
        uf2 = bytearray(self.written("gadget.kdl", "a.uf2"))
        uf2[32 + 20] ^= 1
        self.file("bit.uf2").write_bytes(uf2)
        self.refuse("config", "bit.uf2", status=1, says="bit.uf2: the settings in it are damaged")
        uf2[28] ^= 1
        self.file("other.uf2").write_bytes(uf2)
        self.refuse("config", "other.uf2", status=1, says="it is for the chip family 0xe48bff57")

    def test_records_that_break_rules(self):
        record = bytearray(self.written("gadget.kdl", "a.bin")[:270 + 16])
        end = 8 + struct.unpack_from("<H", record, 6)[0]
        record[16:18] = struct.pack("<H", 1000)  # column
        record[22 + 2] = record[22]              # select on the pin of clock
        for place in (end,):
            record[place:place + 4] = struct.pack("<I", zlib.crc32(record[:end]))
        self.file("bad.bin").write_bytes(record)
        for says in ("bad.bin: settings that a Pico cannot follow", "column 1000", "GP18 is taken twice: by clock and by select"):
            self.refuse("config", "bad.bin", status=1, says=says)

    def test_outputs(self):
        for output in ("a", "a.txt", "a.KDL", "uf2"):
            self.refuse("config", "pico-st7789", "-o", output, status=2, says=".kdl (text), .bin (sector) or .uf2")
        self.refuse("config", "gadget.kdl", "-o", "gadget.kdl", status=1, says="would overwrite the file that is read")
        self.refuse("config", "gadget.kdl", "-o", "none/a.bin", status=1, says="create the folder first")
        self.file("full.bin").write_text("before")
        self.refuse("config", "gadget.kdl", "-o", "full.bin", status=1, says="full.bin", limit=1000)
        self.assertEqual(self.file("full.bin").read_text(), "before")


class DocumentTest(CommandTest):
    def test_what_docs_config_md_shows_is_right(self):
        shown = re.findall(r"^```kdl\n(.*?)^```$", (ROOT / "docs/config.md").read_text(), re.MULTILINE | re.DOTALL)
        scenes = [text for text in shown if text.startswith("kfast ")]
        self.assertTrue(0 < len(scenes) < len(shown))
        for text in shown:
            name, command = ("shown.kfast", "check") if text in scenes else ("shown.kdl", "config")
            (self.folder / name).write_text(text)
            self.assertEqual(self.run_kfast(command, name).stderr, "")

    def test_docs_config_md_has_all_ready_configurations(self):
        text = (ROOT / "docs/config.md").read_text()
        for name in READY:
            self.assertIn(f"| `{name}` |", text)


class WiringTest(CommandTest):
    def wires(self, name):
        report = json.loads(self.run_kfast("wiring", name, "--json").stdout)
        self.assertEqual(report["board"], "pico")
        return {(wire["part"], wire["end"]): wire for wire in report["connections"]}

    def test_for_people(self):
        told = self.run_kfast("wiring", "pico-st7789").stdout
        self.assertTrue(told.startswith("pico-st7789: st7789 by spi, picture 240 x 240\n"
                                        "firmware: build/pico/pico-spi.bin\n\ndisplay\n"))
        self.assertRegex(told, r"\n  SCL, SCK or CLK +GP18 +pin 24 +right +SPI0 SCK\n")
        self.assertRegex(told, r"\n  GND +GND +pin 38 +right\n")
        self.assertRegex(told, r"\n +GP13 17 \|o +o\| 24 GP18 +SCL\n")
        self.assertFalse(any(line.endswith(" ") for line in told.splitlines()))

    def test_for_programs(self):
        wires = self.wires("pico-ssd1306-i2c")
        self.assertEqual(wires["display", "SDA"], {"part": "display", "end": "SDA", "gpio": 4, "name": "GP4", "pin": 6,
                                                   "side": "left", "purpose": "I2C0 SDA"})
        self.assertIsNone(wires["display", "GND"]["gpio"])
        parallel = self.wires("pico-ili9341-parallel")
        self.assertEqual([parallel["display", f"D{bit}"]["gpio"] for bit in range(8)], list(range(8)))

    def test_a_beam(self):
        report = json.loads(self.run_kfast("wiring", "pico-xy-galvo", "--json").stdout)
        self.assertEqual(report["beam"], {"rate": 30000, "laser": True})
        self.assertEqual((report["bus"], report["firmware"]), ("dac", "build/pico/pico-xy.bin"))
        self.assertNotIn("panel", report)
        self.assertEqual(self.wires("pico-xy-galvo")["MCP4922", "LDAC (8)"]["gpio"], 16)
        told = self.run_kfast("wiring", "pico-xy-galvo").stdout
        self.assertTrue(told.startswith("pico-xy-galvo: a beam by dac, 30000 points a second\n"
                                        "firmware: build/pico/pico-xy.bin\n\nMCP4922\n"))
        self.assertIn("\n  VOUTA (14)  x\n  VOUTB (10)  y\n", told)
        self.assertRegex(told, r"\n  Z or BLANK +GP20 +pin 26 +right +dark when high\n")

    def test_the_firmware_is_named(self):
        for name, bus in (("pico-ssd1306-i2c", "i2c"), ("pico-ili9341-parallel", "parallel"), ("pico-gc9a01", "spi")):
            report = json.loads(self.run_kfast("wiring", name, "--json").stdout)
            self.assertEqual((report["bus"], report["firmware"]), (bus, f"build/pico/pico-{bus}.bin"))

    def test_controls(self):
        (self.folder / "g.kdl").write_text(GADGET.replace("clip idle", 'knob 27 place "wide awake"; clip idle'))
        wires = self.wires("g.kdl")
        self.assertEqual(wires["knob 1", "slider"]["pin"], 32)
        self.assertEqual(wires["knob 1", "slider"]["purpose"], "place wide awake")
        self.assertEqual(wires["button 2", "one leg"]["gpio"], 12)
        (self.folder / "g.kdl").write_text(GADGET.replace("clip idle", "knob 27 input gaze"))
        self.assertEqual(self.wires("g.kdl")["knob 1", "slider"]["purpose"], "input gaze")
        self.assertEqual(wires["button 2", "other leg"]["name"], "GND")

    def test_wrong_usage(self):
        self.refuse("wiring", status=2, says="INPUT is required")
        self.refuse("wiring", "pico-gc9a10", status=1, says='did you mean "pico-gc9a01"?')


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
