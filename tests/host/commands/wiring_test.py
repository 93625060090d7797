"""Which wire goes where: kfast wiring."""

import json
import unittest

from command_case import CommandTest
from gadget import GADGET


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

    def test_a_module_without_cs(self):
        printed = self.run_kfast("wiring", "pico-st7789").stdout
        self.assertIn("No CS on your module? --pin select=none", printed)
        self.assertRegex(printed, r"(?m)^ .*\| 22 GP17 +CS$")
        printed = self.run_kfast("wiring", "pico-st7789", "--pin", "select=none").stdout
        self.assertTrue(printed.startswith("pico-st7789 with select=none: st7789 by spi"))
        self.assertNotIn("No CS", printed)
        self.assertNotIn("CS", printed.split("The Pico from above")[1])
        self.assertRegex(printed, r"\n  CS +GND +pin 38 +right +if there is such a pin: always selected\n")
        for other in ("pico-ssd1306-i2c", "pico-ili9341-parallel", "pico-xy-galvo"):
            self.assertNotIn("No CS", self.run_kfast("wiring", other).stdout)
        self.refuse("wiring", "pico-st7789", "--pin", "select=18", status=2, says="--pin select=18")

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
        self.refuse("wiring", "", status=2, says="INPUT is required")
        self.refuse("wiring", "", "--pin", "dc=8", status=2, says="INPUT is required")
        self.refuse("wiring", "pico-gc9a10", status=1, says='did you mean "pico-gc9a01"?')


if __name__ == "__main__":
    unittest.main()
