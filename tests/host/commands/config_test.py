"""Settings of boards: kfast config."""

import struct
import unittest
import zlib

from command_case import ROOT, CommandTest
from gadget import GADGET
from pretend_firmware import firmware
from uf2_blocks import SETTINGS, memory

READY = ["pico-st7789", "pico-ili9341", "pico-gc9a01", "pico-ssd1306", "pico-ssd1306-i2c", "pico-ili9341-parallel",
         "pico-xy-scope", "pico-xy-galvo"]

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

    def test_standard_output_is_where_a_text_goes_unless_a_file_is_named(self):
        self.assertEqual(self.run_kfast("config", "gadget.kdl", "-o", "-").stdout, self.text("gadget.kdl"))
        self.assertFalse(self.file("-").exists())

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

    def test_docs_config_md_has_all_ready_configurations(self):
        text = (ROOT / "docs/config.md").read_text()
        for name in READY:
            self.assertIn(f"| `{name}` |", text)


if __name__ == "__main__":
    unittest.main()
