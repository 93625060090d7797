"""Shows that the compiler refuses wrong settings and says why: wrong_settings_test.py <compiler> <root>"""

import subprocess
import sys
import unittest

COMPILER, ROOT = sys.argv[1:3]

PROGRAM = """
#include "firmware/settings/board_rules.hpp"
using namespace kfast;
constexpr BoardSettings settings = [] {{
    BoardSettings wrong;
    wrong.bus_clock = 10'000'000;
    wrong.pin(PinRole::clock) = 18;
    wrong.pin(PinRole::data) = 19;
    wrong.pin(PinRole::dc) = 20;
    {change}
    return wrong;
}}();
constexpr const BoardSettings& used = right_settings<settings>();
"""

KNOB = "wrong.controls[0] = {{ControlKind::knob, ControlAction::{action}, {pin}, {{}}}};"

OLED = "wrong.panel = facts_of(Controller::ssd1306).default_value;"

WRONG = {
    "wrong.bus = BusKind::i2c; wrong.bus_clock = 1000;": "does not speak this bus",
    "wrong.panel.glass = {240, 321};": "within the controller's memory",
    "wrong.panel = facts_of(Controller::ssd0323).default_value; wrong.panel.glass.width = 127;": "multiples",
    OLED + "wrong.panel.rotation = Rotation::quarter;": "by quarters",
    "wrong.bus_clock = 62'500'001;": "above 62.5 MHz",
    "wrong.bus_clock = 0;": "too low",
    OLED + "wrong.bus = BusKind::i2c; wrong.i2c_address = 0x78;": "0x08 to 0x77",
    "wrong.pin(PinRole::dc) = no_pin;": "lacks a pin",
    "wrong.pin(PinRole::reset) = 25;": "not on the edge of a Pico",
    "wrong.pin(PinRole::reset) = 18;": "have the same pin",
    "wrong.pin(PinRole::clock) = 17;": "does not carry its function",
    "wrong.pin(PinRole::clock) = 14;": "different units",
    KNOB.format(action="speed", pin=22): "needs one of the pins 26 to 28",
    KNOB.format(action="sleep", pin=26): "not for its kind",
    KNOB.format(action="input", pin=26): "does not name it",
}


def compiled(change):
    return subprocess.run([COMPILER, "-std=c++20", "-fsyntax-only", "-I", ROOT, "-x", "c++", "-"],
                          input=PROGRAM.format(change=change), capture_output=True, text=True, timeout=100)


class WrongSettings(unittest.TestCase):
    def test_right_settings_compile(self):
        self.assertEqual(0, compiled("").returncode, compiled("").stderr)

    def test_each_rule_has_its_message(self):
        for change, message in WRONG.items():
            with self.subTest(change=change):
                run = compiled(change)
                errors = [line for line in run.stderr.splitlines() if "error:" in line]
                self.assertNotEqual(0, run.returncode)
                self.assertIn(message, " ".join(errors))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
