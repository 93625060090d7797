"""`kfast panel` on a Linux computer whose GPIO chip and SPI device are not there, and what the display shows:

    linux_panel_test.py <folder of kfast and kfast-panel> <the library that stands in for the kernel> <scene.kfast>"""

import pathlib
import signal
import sys
import tempfile
import unittest

from linux_computer import CHIP, LinuxComputer

PROGRAMS, STAND_IN, SCENE = sys.argv[1:4]
del sys.argv[1:4]

FRAMES = 6
MOST_FRAMES = 100
DC, RESET, BACKLIGHT, SELECT, WR = 25, 27, 24, 8, 17
LINES = {"dc": DC, "reset": RESET, "backlight": BACKLIGHT}
PARALLEL = LINES | {"wr": WR} | {f"data{bit}": bit for bit in range(8)}
SPI = ("--spi", "/dev/spidev0.0")
PINS = ("--pin", "dc=GPIO25", "--pin", f"reset={RESET}", "--pin", "backlight=GPIO24")
SLPIN, DISPOFF = "10", "28"


def pins(lines):
    return [word for role, line in lines.items() for word in ("--pin", f"{role}={line}")]


def settings(panel, bus="spi"):
    return f"board pico {{ panel {panel}; bus {bus}; pins clock=18 data={0 if bus == 'parallel' else 19} dc=16 }}"


class PanelTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="kfast")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.computer = LinuxComputer(self.folder, PROGRAMS, STAND_IN)

    def play(self, *arguments, status=0, scene=SCENE):
        if "--frames" not in arguments:
            arguments += ("--frames", MOST_FRAMES)  # so that it ends, whatever goes wrong
        done = self.computer.kfast("panel", scene, *arguments)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        return done

    def refuse(self, *arguments, status, says):
        done = self.play(*arguments, status=status)
        self.assertIn(says, done.stderr)
        self.assertEqual(done.stderr.count("kfast:"), 1)

    def expected(self, *options, scene=SCENE):
        """The hash of every frame of a pass."""
        done = self.computer.kfast("hash", scene, *options, stand_in=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        return [line.split(" ")[1] for line in done.stdout.splitlines()]

    def expect_dark(self, wires):
        """As it is to be left: no light, asleep, lines given back."""
        self.assertEqual(wires.levels(BACKLIGHT)[-1], 0)
        self.assertEqual([rest[1] for _, what, rest in wires.events if what == "spi"][-2:], [DISPOFF, SLPIN])
        self.assertEqual({int(rest[1]) for _, what, rest in wires.events if what == "free"}, set(LINES.values()))

    # Pictures

    def test_every_controller_shows_every_frame_as_the_preview(self):
        for panel in ("st7789", "ili9341", "st7735", "gc9a01", "ssd1306", "ssd1351", "ssd0323"):
            with self.subTest(panel=panel):
                wanted = self.expected("--panel", panel)
                done = self.play("--panel", panel, *SPI, *PINS, "--frames", len(wanted))
                self.assertIn(f"{len(wanted)} frames shown, 0 left out", done.stdout)
                self.assertEqual(self.computer.hashes(settings(panel), LINES), wanted)

    def test_eight_wires(self):
        for panel in ("st7789", "ili9341", "st7735"):
            for more in ({}, {"select": SELECT}):
                with self.subTest(panel=panel, more=more):
                    lines = PARALLEL | more
                    self.play("--panel", panel, "--bus", "parallel", *pins(lines), "--frames", FRAMES)
                    self.assertEqual(self.computer.hashes(settings(panel, "parallel"), lines),
                                     self.expected("--panel", panel)[:FRAMES])
                    self.assertEqual(self.computer.wires().levels(SELECT)[-1:], [1] if more else [])

    def test_a_glass_of_its_own_that_is_turned(self):
        self.play("--panel", "st7789", "--glass", "135x240", "--column", 52, "--row", 40, "--rotation", 90, "--bgr",
                  "--not-inverted", *SPI, *PINS, "--frames", FRAMES)
        glass = "st7789 135 240 column=52 row=40 rotation=90 colours=bgr inverted=#false"
        self.assertEqual(self.computer.hashes(settings(glass), LINES), self.expected("--size", "240x135")[:FRAMES])

    def test_a_chip_select_that_is_a_gpio_line(self):
        self.play("--panel", "st7735", *SPI, *PINS, "--pin", f"select={SELECT}", "--frames", FRAMES)
        self.assertEqual(self.computer.hashes(settings("st7735"), LINES | {"select": SELECT}),
                         self.expected("--panel", "st7735")[:FRAMES])
        self.assertEqual(self.computer.wires().levels(SELECT)[-1], 1)
        self.assertIn("mode spidev0.0 64", (self.folder / "wires").read_text())  # SPI_NO_CS

    def test_transfers_keep_to_the_buffer_of_the_kernel(self):
        for bufsiz, most in (("4096\n", 4096), ("65536\n", 11520), (None, 4096)):
            with self.subTest(bufsiz=bufsiz):
                self.computer.describe("sys/module/spidev/parameters/bufsiz", bufsiz)
                self.computer.describe("dev/spidev0.0", f"most {most}\n")
                self.play("--panel", "st7789", *SPI, *PINS, "--frames", 1)
                self.assertEqual(max(self.computer.wires().transfers()), most)
                self.assertEqual(self.computer.hashes(settings("st7789"), LINES), self.expected("--panel", "st7789")[:1])

    def test_clips_speed_and_inputs(self):
        scene = self.folder / "told.kfast"
        scene.write_text('kfast 1\ncanvas 60 40 fps=30\ninput gaze min=-1 max=1\ninput note kind=text glyphs="0-9" max=3\n'
                         "input plot kind=drawing points=4 strokes=1\n"
                         "object eye fill=white { key 0 { circle 10 10 r=5 }; key 10 { circle 40 10 r=5 };"
                         " track y input=gaze { at -1 0; at 1 20 } }\n"
                         "object line stroke=white width=2 live=plot\n"
                         'object text stroke=white width=1 { text input=note at="5,38" size=10 font=hershey-sans }\n'
                         "clip sway from=2 to=6 loop=ping-pong\n")
        (self.folder / "points.txt").write_text("5,5 50,30\n")
        told = ("--clip", "sway", "--speed", "0.5", "--input", "gaze=0.5", "--input", "note=42",
                "--drawing", f"plot={self.folder / 'points.txt'}")
        wanted = self.expected("--panel", "st7735", *told, scene=scene)
        plain = self.expected("--panel", "st7735", scene=scene)
        self.assertNotEqual(wanted[0], plain[2])
        self.play("--panel", "st7735", *SPI, *PINS, *told, "--frames", len(wanted), scene=scene)
        self.assertEqual(self.computer.hashes(settings("st7735"), LINES), wanted)

    # Order of things

    def test_the_light_comes_with_the_first_picture_and_goes_before_the_display_sleeps(self):
        self.play("--panel", "st7789", *SPI, *PINS, "--frames", 2)
        wires = self.computer.wires()
        self.assertEqual(wires.levels(BACKLIGHT), [0, 1, 0])
        self.assertEqual(wires.levels(RESET), [1, 0, 1])
        at = {level: index for index, (_, what, rest) in enumerate(wires.events)
              if what == "line" and int(rest[1]) == BACKLIGHT for level in [int(rest[2])]}
        before, after = wires.events[:at[1]], wires.events[at[0]:]
        pixels = sum(len(rest[1]) // 2 for _, what, rest in before if what == "spi")
        self.assertGreater(pixels, 240 * 240 * 2)
        self.assertEqual([rest[1] for _, what, rest in after if what == "spi"], [DISPOFF, SLPIN])
        self.expect_dark(wires)

    def test_every_display_is_left_alone_for_a_while_after_its_reset(self):
        for panel in ("st7789", "ssd1306", "ssd1351", "ssd0323"):
            with self.subTest(panel=panel):
                self.play("--panel", panel, *SPI, *PINS, "--frames", 1)
                events = self.computer.wires().events
                _, low, high = (time for time, what, rest in events if what == "line" and int(rest[1]) == RESET)
                first = next(time for time, what, _ in events if what == "spi")
                self.assertGreaterEqual(high - low, 10_000)
                self.assertGreaterEqual(first - high, 120_000_000)

    def test_the_scene_may_come_last(self):
        done = self.computer.kfast("panel", "--panel", "st7735", *SPI, "--frames", 1, *PINS, SCENE)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_no_brightness_is_no_light(self):
        self.play("--panel", "st7789", *SPI, *PINS, "--frames", 2, "--brightness", 0)
        self.assertEqual(self.computer.wires().levels(BACKLIGHT), [0])

    def test_signals_leave_the_display_dark(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            for sleep in (1, 4, 12):  # during the reset, the start-up, and between frames
                with self.subTest(number=number, sleep=sleep):
                    self.computer.describe("signal", f"{int(number)} {sleep}\n")
                    done = self.play("--panel", "st7789", *SPI, *PINS)
                    self.assertNotIn(f"{MOST_FRAMES} frames shown", done.stdout)
                    self.expect_dark(self.computer.wires())

    def test_a_signal_in_the_middle_of_a_picture_does_not_wait_for_its_end(self):
        self.computer.describe("dev/spidev0.0", "interrupted-at 58\n")  # among the pixels of the first picture
        done = self.play("--panel", "st7789", *SPI, *PINS)
        self.assertIn("0 frames shown", done.stdout)
        wires = self.computer.wires()
        self.assertGreater(wires.transfers()[57], 1000)
        self.assertLess(sum(wires.transfers()[57:]), 240 * 240)  # half a picture
        self.expect_dark(wires)

    def test_the_shortest_reset_is_kept_though_a_signal_comes(self):
        self.computer.describe("signal", "2 1\n")
        self.play("--panel", "st7789", *SPI, *PINS)
        self.assertEqual(self.computer.hashes(settings("st7789"), LINES), [])

    def test_a_slow_display_leaves_out_frames(self):
        self.computer.describe("dev/spidev0.0", "nanoseconds-per-byte 600\n")  # 13 MHz: 69 ms for all pixels
        done = self.play("--panel", "st7789", *SPI, *PINS, "--frames", 1, "--clock", "13MHz")
        self.assertIn("13 MHz", done.stdout)
        self.assertRegex(done.stdout, "1 frames shown, 0 left out")
        done = self.play("--panel", "st7789", *SPI, *PINS, "--frames", 2, "--clock", "13MHz")
        self.assertRegex(done.stdout, "2 frames shown, [1-9] left out")

    def test_who_was_stopped_goes_on_at_once(self):
        self.computer.describe("stopped", "12 2400\n")
        self.play("--panel", "st7735", *SPI, *PINS, "--frames", 30)
        times = [time for time, *_ in self.computer.wires().events]
        self.assertGreater(times[-1] - times[0], 2400e9)
        self.assertLess(times[-1] - times[0], 2410e9)

    # What goes wrong

    def test_an_spi_device_that_is_not_there(self):
        self.refuse("--panel", "st7789", "--spi", "/dev/spidev1.0", *PINS, status=3, says="there is /dev/spidev0.0")
        self.refuse("--panel", "st7789", *PINS, status=2, says="There is /dev/spidev0.0")
        self.computer.describe("dev/spidev0.0", None)
        self.refuse("--panel", "st7789", *SPI, *PINS, status=3, says="raspi-config")

    def test_an_spi_device_that_cannot_be_had(self):
        for error, status, says in ((13, 4, "group 'spi'"), (16, 8, "in use"), (5, 8, "Input/output error")):
            with self.subTest(error=error):
                self.computer.describe("dev/spidev0.0", f"error {error}\n")
                self.refuse("--panel", "st7789", *SPI, *PINS, status=status, says=says)
        self.computer.describe("dev/spidev0.0", "slowest 100000\nalways-selects\n")
        self.refuse("--panel", "st7789", *SPI, *PINS, "--clock", "9600Hz", status=8, says="9600 Hz")
        self.refuse("--panel", "st7789", *SPI, *PINS, "--pin", f"select={SELECT}", status=8, says="chip select")

    def test_a_buffer_that_is_smaller_than_the_kernel_says(self):
        self.computer.describe("dev/spidev0.0", "most 1024\n")
        self.refuse("--panel", "st7789", *SPI, *PINS, status=8, says="spidev.bufsiz")
        self.assertEqual(self.computer.wires().levels(BACKLIGHT)[-1], 0)

    def test_a_device_that_is_unbound_meanwhile(self):
        for transfers, light in ((0, [0]), (3, [0]), (100, [0]), (250, [0, 1, 0])):
            with self.subTest(transfers=transfers):
                self.computer.describe("dev/spidev0.0", f"gone-after {transfers}\n")
                self.refuse("--panel", "st7789", *SPI, *PINS, status=5, says="/dev/spidev0.0 is gone")
                self.assertEqual(self.computer.wires().levels(BACKLIGHT), light)
        self.computer.describe("dev/spidev0.0", "")
        self.computer.describe("dev/gpiochip0", CHIP + "gone-after 9\n")
        self.refuse("--panel", "st7789", *SPI, *PINS, status=5, says="gpiochip0 (pinctrl-test)")

    def test_gpio_lines_that_cannot_be_had(self):
        self.computer.describe("dev/gpiochip0", CHIP + f"taken {DC} spi0 CS1\n")
        self.refuse("--panel", "st7789", *SPI, *PINS, status=8, says="line 25 by 'spi0 CS1'")
        self.computer.describe("dev/gpiochip0", "error 13\n")
        self.refuse("--panel", "st7789", *SPI, *PINS, status=4, says="group 'gpio'")
        self.computer.describe("dev/gpiochip0", None)
        self.refuse("--panel", "st7789", *SPI, *PINS, status=3, says="no GPIO chip")

    def test_usage(self):
        for arguments, says in (
                (SPI, "--pin dc=LINE"),
                ((*SPI, "--pin", "dc=25", "--pin", "dc=24"), "two lines for dc"),
                ((*SPI, "--pin", "dd=25"), 'did you mean "dc"'),
                ((*SPI, "--pin", "dc"), "dc=GPIO25"),
                ((*SPI, "--pin", "dc="), "dc=GPIO25"),
                ((*SPI, *PINS, "--pin", "wr=3"), "--bus parallel"),
                (("--bus", "parallel", *pins(LINES | {"wr": WR})), "--pin data0=LINE"),
                (("--bus", "parallel", *SPI, *pins(PARALLEL)), "neither --spi"),
                (("--bus", "i2c", *PINS), "spi or parallel"),
                ((*SPI, *PINS, "--clock", "40"), "40MHz"),
                ((*SPI, *PINS, "--clock", "nanMHz"), "40MHz"),
                ((*SPI, *PINS, "--clock", "0.1Hz"), "40MHz"),
                ((*SPI, *PINS, "--rotation", 45), "--rotation"),
                ((*SPI, *PINS, "--glass", "500x20"), "does not lie within"),
                ((*SPI, *PINS, "--column", -1), "does not lie within"),
                ((*SPI, *PINS, "--frames", 0), "--frames"),
                ((*SPI, *PINS, "--brightness", "101%"), "--brightness"),
                ((*SPI, *PINS, "--clip", "none"), "--clip"),
                ((*SPI, *PINS, "--input", "none=1"), "--input"),
                ((*SPI, "--pin", "dc=5", "--pin", "reset=5"), "asked for twice")):
            with self.subTest(arguments=arguments):
                self.refuse("--panel", "st7789", *arguments, status=2, says=says)
                self.assertEqual(self.computer.wires().transfers(), [])
        self.refuse("--panel", "ssd1306", "--bus", "parallel", *pins(PARALLEL), status=2,
                    says="--bus: ssd1306 cannot be driven by parallel: leave it out")
        self.refuse("--panel", "ssd1306", *SPI, *PINS, "--rotation", 90, status=2, says="--rotation: ssd1306 cannot turn")
        self.refuse(*SPI, *PINS, status=2, says="--panel")
        self.refuse("--panel", "ili9341", *SPI, *PINS, "--clock", "40MHz", "--frames", 1, status=0,
                    says="take --clock 10 MHz")


if __name__ == "__main__":
    unittest.main()
