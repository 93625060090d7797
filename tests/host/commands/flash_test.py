"""kfast flash, as far as it needs no board: what it refuses before it looks for one, dry runs, and drives, which are
folders. No board that is plugged in where this runs may be written to."""

import json
import os
import pty
import re
import shlex
import struct
import subprocess
import unittest

from command_case import KFAST, ROOT, CommandTest
from pretend_firmware import firmware

NOWHERE = ("--port", "9-9.9.9")  # no board is there
BUSES = ("spi", "i2c", "parallel", "xy")

# Its outlines find no room.
LARGE = "kfast 1\ncanvas 240 240 frames=2\nobject dots fill=red {" + "".join(
    f" circle {4 * (place % 60)} {4 * (place // 60)} r=2;" for place in range(3600)) + " }\n"
# Every picture is another one, as large as the display.
SLOW = """kfast 1
canvas 240 240 fps=120
object flood fill=red { rect 0 0 240 240; key 0 fill=red; key 60 fill=blue }
"""
INFORMATION = "UF2 Bootloader v3.0\nModel: Raspberry Pi RP2\nBoard-ID: {}\n"


def replayed(uf2):
    """What is in flash when all blocks have been taken, in their order, by the beginnings of sectors."""
    flash = {}
    for place in range(0, len(uf2), 512):
        _, _, _, address, size, _, count, _ = struct.unpack_from("<8I", uf2, place)
        if count != 0:
            sector = flash.setdefault(address & ~0xFFF, bytearray(4096))
            sector[address & 0xFFF:(address & 0xFFF) + size] = uf2[place + 32:place + 32 + size]
    return flash


class FlashTest(CommandTest):
    def setUp(self):
        super().setUp()
        images = self.folder / "images"
        images.mkdir()
        for number, bus in enumerate(BUSES):
            (images / f"pico-{bus}.bin").write_bytes(firmware(5000 + number, mark=b"KFPI" + bytes([number, 0, 0, 0])))
        (self.folder / "large.kfast").write_text(LARGE)
        (self.folder / "slow.kfast").write_text(SLOW)
        self.images = {"KFAST_FIRMWARE": str(images)}

    def flash(self, *arguments, **more):
        return self.run_kfast("flash", *arguments, environment=self.images, **more)

    def refused(self, *arguments, status, says):
        self.refuse("flash", *arguments, *NOWHERE, environment=self.images, status=status, says=says)

    def planned(self, *arguments):
        return json.loads(self.flash(*arguments, "--dry-run", "--json", *NOWHERE).stdout)

    def drive(self, board="RPI-RP2"):
        drive = self.folder / "drive"
        drive.mkdir()
        (drive / "INFO_UF2.TXT").write_text(INFORMATION.format(board))
        return "--drive", "drive", "--no-wait"


class RefusalTest(FlashTest):
    def test_scenes(self):
        self.refused("none.kfast", status=1, says="none.kfast: there is no such file")
        (self.folder / "wrong.kfast").write_text("kfast 1\ncanvas 60 40\nobjekt\n")
        self.refused("wrong.kfast", status=1, says="wrong.kfast:3:1: error:")
        self.refused("large.kfast", "--panel", "gc9a01", status=7, says="large.kfast: does not fit pico\n  RAM: ")
        self.refused("large.kfast", "--panel", "gc9a01", status=7, says="Shorten the scene, or draw it with fewer points")

    def test_firmware(self):
        (self.folder / "rubbish.bin").write_bytes(bytes(1000))
        self.refused("--firmware", "rubbish.bin", status=1, says="rubbish.bin: does not begin with a boot block")
        (self.folder / "packed.uf2").write_bytes(b"UF2\n" + bytes(508))
        self.refused("--firmware", "packed.uf2", status=1, says="packed.uf2: is a UF2 file: name the .bin beside it")
        (self.folder / "large.bin").write_bytes(firmware(0x3F001))
        self.refused("--firmware", "large.bin", status=7, says="1 more than lie before the settings")
        self.refused("--firmware", "images/pico-spi.bin", "--config", "pico-ssd1306-i2c", status=1,
                     says="firmware for displays on spi, but the display of pico-ssd1306-i2c is on i2c")
        (self.folder / "images/pico-i2c.bin").unlink()
        for arguments in ([], ["--panel", "ssd1306-i2c"], ["--pin", "reset=9"]):
            self.refused(*arguments, status=1, says="there is no pico-i2c.bin in ")
            self.refused(*arguments, status=1, says="scripts/build pico")
        self.planned("--panel", "st7789")  # is for another bus

    def test_settings(self):
        (self.folder / "fast.kdl").write_text("beam scope rate=(kHz)900\n")
        for arguments, status, says in (
                (["--panel", "gc9a02"], 2, 'did you mean "gc9a01"?'),
                (["--panel", "st7735"], 2, "'st7735' has no ready configuration: make one for --config"),
                (["--config", "gadget"], 1, "there is no configuration"),
                (["--config", "pico-st7789", "--panel", "st7789"], 2, "--panel"),
                (["--panel", "xy-scope"], 2, "'xy-scope' has no ready configuration"),
                (["--beam", "galvos"], 1, 'did you mean "galvo"?'),
                (["--beam", "fast.kdl"], 2, "cannot carry 900000 points a second: it can carry "),
                (["--beam", "galvo", "--panel", "st7789"], 2, "--panel"),
                (["--beam", "galvo", "--config", "pico-xy-galvo"], 2, "--config"),
                (["--beam", "scope", "--pin", "ldac=none"], 2, "--pin ldac=none: dac needs a pin for ldac"),
                (["--pin", "dc"], 2, "'dc': write ROLE=GPIO, like dc=8"),
                (["--panel", "sh1106"], 2, "'sh1106' is unknown: an SH1106, often sold as an SSD1306"),
                (["--pin", "rst=3"], 2, "'rst=3': here it is called reset"),
                (["--pin", "dcc=3"], 2, 'did you mean "dc"?'),
                (["--pin", "dc=30"], 2, "'dc=30': the number of a GPIO is expected"),
                (["--pin", "dc="], 2, "the number of a GPIO is expected"),
                (["--pin", "dc=8x"], 2, "the number of a GPIO is expected"),
                (["--pin", "dc=8", "--pin", "dc=9"], 2, "'dc=9': there is another pin for dc"),
                (["--panel", "gc9a01", "--pin", "dc=25"], 2, "--pin dc=25: GP25 is not on the edge of a Pico: use one of"),
                (["--panel", "gc9a01", "--pin", "dc=18"], 2, "--pin dc=18: GP18 is taken twice: by clock and by dc"),
                (["--panel", "gc9a01", "--pin", "clock=3"], 2, "--pin clock=3: GP3 cannot carry spi clock"),
                (["--panel", "gc9a01", "--pin", "clock=10"], 2, "--pin clock=10: clock on GP10 is SPI1 SCK"),
                (["--panel", "gc9a01", "--pin", "dc=none"], 2, "--pin dc=none: spi needs a pin for dc")):
            with self.subTest(arguments):
                self.refused(*arguments, status=status, says=says)

    def test_usage(self):
        self.refused("--no-firmware", status=2, says="with --no-firmware, a scene or settings")
        self.refused("--no-firmware", "--firmware", "f.bin", status=2, says="--no-firmware")
        self.refused("--board", "pico2", status=2, says="a Pico 2 (RP2350, Cortex-M33) is not supported yet: there is no firmware for it")
        self.refused("--board", "bluepill", status=2, says="there is no firmware for 'bluepill': allowed: pico")
        self.refused("--board", "esp32", status=2, says="'esp32': an ESP32 (Xtensa LX6) is not supported yet: there is no firmware for it")
        self.refused("--verify-only", "--dry-run", status=2, says="--dry-run")
        self.refused("--device", "E6", status=2, says="excludes --device")
        for device in ("sim", "sim:/run/board.sock"):
            self.refuse("flash", "once.kfast", "--device", device, status=2,
                        says=f"flash needs a board of its own; 'kfast play' and 'kfast upload' reach the simulator with --device {device}\n")
        self.refused("--reset-line", "GPIO17", status=2, says="--reset-line requires --boot-line")
        self.refused("--gpio-chip", "0", status=2, says="--gpio-chip requires --reset-line")

    def test_places(self):
        self.refused("once.kfast", status=3, says='there is no board in its boot loader at "9-9.9.9"')
        self.refuse("flash", "--drive", ".", environment=self.images, status=3, says=". is no drive of a boot loader")
        drive = self.drive("RP2350")
        self.refuse("flash", *drive, environment=self.images, status=11, says="drive is the drive of the board RP2350")
        self.refuse("flash", "once.kfast", "--no-firmware", "--reset-line", "KFAST-NONE-1", "--boot-line", "KFAST-NONE-2",
                    environment=self.images, status=3, says="kfast: ")  # there are no such lines, or no chip at all


class DryRunTest(FlashTest):
    def test_for_people(self):
        told = self.flash("once.kfast", "--panel", "gc9a01", "--pin", "dc=8", "--dry-run", *NOWHERE).stdout
        self.assertRegex(told, r"^firmware of 5000 bytes, settings of pico-gc9a01 with dc=8, scene of \d+ bytes: 4 sectors\n"
                               r"to be written: those that differ from what flash holds, which is not known\n"
                               r"  0x10000000, 2 sectors, 8192 bytes\n  0x1003f000, 2 sectors, 8192 bytes\n$")

    def test_for_programs(self):
        self.assertEqual(self.planned("--panel", "ssd1306-i2c"), {
            "board": "pico", "contents": "firmware of 5001 bytes, settings of pico-ssd1306-i2c", "port": None, "drive": None,
            "sectors": 3, "differing": None, "written": 0, "verified": False, "restarted": False, "serial": None,
            "left_slot": None, "plays": None})

    def test_the_bus_decides_the_firmware(self):
        for number, panel in enumerate(("st7789", "ssd1306-i2c", "ili9341-parallel")):
            self.assertIn(f"firmware of {5000 + number} bytes", self.planned("--panel", panel)["contents"])
        (self.folder / "slow.kdl").write_text("beam crt rate=(kHz)20\n")
        for beam, settings in (("scope", "pico-xy-scope"), ("galvo", "pico-xy-galvo"), ("crt", "pico-xy-scope with beam crt"),
                               ("slow.kdl", "pico-xy-scope with beam slow.kdl")):
            self.assertEqual(self.planned("--beam", beam)["contents"], f"firmware of 5003 bytes, settings of {settings}")
        self.assertIn("settings of pico-xy-scope with blank=21,", self.planned(
            "once.kfast", "--beam", "scope", "--pin", "blank=21")["contents"])

    def test_a_scene_that_has_no_room_beside_the_points_of_a_beam(self):
        self.refused("large.kfast", "--beam", "scope", status=7, says="large.kfast: does not fit pico-xy\n  RAM: ")

    def test_quiet(self):
        result = self.flash("once.kfast", "--panel", "st7789", "--dry-run", "--quiet", *NOWHERE)
        self.assertEqual((result.stdout, result.stderr), ("", ""))

    def test_slow_scenes_are_warned_of(self):
        told = self.flash("slow.kfast", "--panel", "ili9341", "--dry-run", *NOWHERE)
        self.assertIn("slow.kfast: warning: it plays slower than it wants on this board: speed: every second frame takes",
                      told.stderr)

    def test_names_that_the_scene_has_not_are_warned_of(self):
        text = self.run_kfast("config", "pico-st7789").stdout
        (self.folder / "gadget.kdl").write_text(text.rstrip().removesuffix("}") + "clip blimk\n}\n")
        told = self.flash("marked.kfast", "--config", "gadget.kdl", "--dry-run", *NOWHERE)
        self.assertIn('gadget.kdl: warning: marked.kfast: there is no clip "blimk"', told.stderr)


class DriveTest(FlashTest):
    def test_the_drive_gets_all_of_it(self):
        drive = self.drive()
        told = self.flash("once.kfast", "--panel", "st7789", *drive)
        self.assertIn("4 sectors\ncopied to drive, which cannot be verified\n", told.stdout)
        self.assertEqual(told.stderr, "writing 5 sectors\n")
        flash = replayed((self.folder / "drive/KFAST.UF2").read_bytes())
        self.assertEqual(list(flash), [0x10000000, 0x10001000, 0x1003F000, 0x10040000])
        image = (flash[0x10000000] + flash[0x10001000])[:5000]
        self.assertEqual(image, (self.folder / "images/pico-spi.bin").read_bytes())
        self.run_kfast("config", "pico-st7789", "-o", "settings.bin")
        self.assertEqual(flash[0x1003F000], (self.folder / "settings.bin").read_bytes())
        self.run_kfast("compile", "once.kfast")
        scene = (self.folder / "once.kfb").read_bytes()
        self.assertEqual(flash[0x10040000][:len(scene)], scene)

    def test_a_bar_on_a_terminal(self):
        terminal, end = pty.openpty()
        self.addCleanup(os.close, terminal)
        subprocess.run([KFAST, "flash", "--panel", "st7789", *self.drive()], cwd=self.folder, stdout=subprocess.PIPE,
                       stderr=end, env={**os.environ, **self.images}, timeout=120, check=True)
        os.close(end)
        told = os.read(terminal, 100_000).decode()
        self.assertIn("\rwriting   [", told)
        self.assertIn("100 %", told)
        self.assertRegex(told, r"\r +\r$", "the bar goes away")

    def test_a_display_that_is_not_known_is_warned_of(self):
        drive = self.drive()
        self.assertIn("which display the board has is not known", self.flash("once.kfast", *drive).stderr)
        self.assertNotIn("is not known", self.flash("once.kfast", *drive, "--no-firmware").stderr)

    def test_pins_are_changed(self):
        self.flash("--panel", "st7789", "--pin", "tearing=22", "--pin", "dc=8", "--pin", "backlight=none", *self.drive())
        sector = replayed((self.folder / "drive/KFAST.UF2").read_bytes())[0x1003F000]
        (self.folder / "settings.bin").write_bytes(sector)
        told = self.run_kfast("config", "settings.bin").stdout
        for part in ("dc=8", "tearing=22", "reset=20"):
            self.assertIn(part, told)
        self.assertNotIn("backlight", told)
        self.assertNotIn("tearing=#false", told, "the display tells where somebody listens")

    def test_it_cannot_be_verified(self):
        drive = self.drive()
        self.refuse("flash", *drive, "--verify-only", environment=self.images, status=2, says="a drive does not tell what lies")

    def test_pins_alone_need_settings(self):
        drive = self.drive()
        self.refuse("flash", *drive, "--pin", "dc=8", environment=self.images, status=2, says="--pin alone changes the settings")

    def test_a_drive_that_cannot_be_written(self):
        drive = self.drive()
        (self.folder / "drive/KFAST.UF2").mkdir()
        self.refuse("flash", *drive, environment=self.images, status=1, says="cannot write drive/KFAST.UF2")


class DocumentTest(FlashTest):
    def test_commands_of_the_documents(self):
        (self.folder / "eyes.kfast").write_text((self.folder / "once.kfast").read_text())
        (self.folder / "examples").symlink_to(ROOT / "examples")
        commands = [command for document in ("README.md", "docs/flash.md")
                    for command in re.findall(r"^    (?:build/host/bin/)?kfast flash\b(.*)", (ROOT / document).read_text(), re.M)]
        self.assertGreater(len(commands), 5)
        for command in commands:
            with self.subTest(command):
                arguments = shlex.split(command, comments=True)
                if arguments[:1] == ["--pin"]:
                    arguments += ["--panel", "st7789"]  # those of the board, which is not there
                self.planned(*arguments)

    def test_docs_flash_md_has_all_options(self):
        text = (ROOT / "docs/flash.md").read_text()
        for option in {word.rstrip(",") for word in self.run_kfast("flash", "--help").stdout.split() if word.startswith("--")}:
            self.assertIn(f"`{option}", text)


if __name__ == "__main__":
    unittest.main()
