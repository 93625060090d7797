"""Whether scenes fit boards."""

import json
import re
import unittest

from command_case import ROOT, CommandTest

BOARD = """board desk {{
    core {core} clock=(MHz){clock}
    memory flash=(KiB){flash} ram=(KiB){ram}
    bus {bus}
    panel {panel}
    bands {bands}
    reserved flash=(B){reserved} ram=(B){reserved}
}}
"""
USUAL = {"core": "cortex-m0+", "clock": 100, "flash": 256, "ram": 64, "bus": "spi clock=(MHz)40", "panel": "60 40",
         "bands": "(KiB)1", "reserved": 0}

NAMED = """kfast 1
canvas 60 40 frames=8
symbol eye { object shape fill=white { key 0 { circle 0 0 r=6 }; key 8 { rect -8 -4 16 8 } } }
group face { use eye 15 20 }
object still fill=red { rect 0 0 4 4 }
"""

COMB = " ".join(f"L {i} {35 - 9 * (i % 2)}" for i in range(60))
WITHOUT_TRACKS = f"""kfast 1
canvas 60 40 frames=8
object comb fill=red {{{{ path "M 0 40 {COMB} L 60 40 Z" }}}}
object square fill=white {{{{ {{keys}} }}}}
"""

NUMBERS = "\n".join(f"input n{i}; object dot{i} fill=red {{{{ rect 0 0 2 2; track x input=n{i} {{{{ at 0 0 }}}} }}}}" for i in range(13))
PLOT = f"""kfast 1
canvas 60 40 fps=2 frames=8
{NUMBERS}
input plot kind=drawing points={{points}} strokes=2 {{{{ line 5 20 55 20 }}}}
object trace stroke=lime join=bevel live=plot
"""

ZIGZAG = " ".join(f"{2 * (i % 118 if i // 118 % 2 == 0 else 117 - i % 118)} {2 * (i // 118) + i % 2}"
                  for i in range(10_000))
MANY_POINTS = f"""kfast 1
canvas 240 240 frames=2
object small fill=red {{ rect 0 0 9 9 }}
object large stroke=white width=2 {{ key 0 {{ line {ZIGZAG} }}; key 1 {{ line 0 0 9 9 }} }}
"""
MANY_OBJECTS = "kfast 1\ncanvas 240 240 frames=1\n" + "".join(
    f"object dot{i} fill=red {{ circle {i % 240} {i // 10} r=2 }}\n" for i in range(2_000))

BEAM_BOARD = """board bench {{
    core cortex-m0+ clock=(MHz){clock}
    memory flash=(KiB)256 ram=(KiB){ram}
    bus dac clock=(MHz)20
    beam {beam}
    bands {bands}
}}
"""
USUAL_BEAM = {"clock": 100, "ram": 96, "beam": "scope", "bands": "(KiB)16"}
BOX = """kfast 1
canvas 256 256 frames=10
object box stroke=white { key 0 { rect 64 64 128 128 }; key 10 { rect 96 96 64 64 } }
"""
DOTS = "kfast 1\ncanvas 256 256 frames=2\nobject dots stroke=white cap=round {\n" + "".join(
    f"    line {i % 64 * 4} {i // 64 * 4} {i % 64 * 4} {i // 64 * 4}\n" for i in range(2000)) + "}\n"


class FitTest(CommandTest):
    def write(self, name, text):
        (self.folder / name).write_text(text)

    def beam_board(self, **changes):
        (self.folder / "bench.kdl").write_text(BEAM_BOARD.format(**{**USUAL_BEAM, **changes}))
        return ("--board", "bench.kdl")

    def board(self, **changes):
        (self.folder / "desk.kdl").write_text(BOARD.format(**{**USUAL, **changes}))
        return ("--board", "desk.kdl")

    def report(self, *arguments, status=0):
        return json.loads(self.run_kfast("fit", *arguments, "--json", status=status).stdout)

    def refused(self, *arguments):
        """The report, and what is said on standard error, line by line."""
        told = self.run_kfast("fit", *arguments, "--json", status=1)
        report = json.loads(told.stdout)
        self.assertFalse(report["fits"])
        first, *reasons = told.stderr.splitlines()
        self.assertIn("does not fit", first)
        self.assertEqual([reason.strip() for reason in reasons], report["reasons"])
        return report

    def test_a_scene_that_fits(self):
        report = self.report("repeat.kfast", *self.board())
        self.assertTrue(report["fits"])
        self.assertEqual(report["reasons"], [])
        self.assertEqual((report["board"], report["processor"]), ("desk", "cortex-m0+"))
        self.assertEqual(report["panel"], {"name": "", "width": 60, "height": 40, "format": "rgb565"})
        self.assertEqual(report["fps"]["wanted"], 30)

    def test_a_scene_for_a_beam(self):
        self.write("box.kfast", BOX)
        report = self.report("box.kfast", *self.beam_board())
        busiest = report["busiest"]
        self.assertTrue(report["fits"])
        self.assertEqual((busiest["frame"], busiest["lines"], busiest["lit"], busiest["travel"]), (0, 1, 2, 0))
        self.assertEqual(busiest["points"], 4 * 86)  # sides of 32768 units, steps of 384
        self.assertAlmostEqual(busiest["refresh"], 100_000 / 344)
        self.assertEqual((report["pictures"], report["hasty"], report["incomplete"]), (10, 0, 0))
        self.assertLess(report["mean_points"], busiest["points"])
        ram = report["ram"]
        self.assertEqual(ram["used"], sum(ram[part] for part in ("block", "buffers", "static", "stack", "reserved")))
        self.assertEqual(ram["buffers"], 2 * 16384)
        told = self.run_kfast("fit", "box.kfast", *self.beam_board()).stdout
        self.assertIn("344 points, drawn 290.7 times a second", told)
        self.assertIn("of RAM: buffers 32 KiB, ", told)

    def test_the_order_of_lines_takes_its_time(self):
        self.write("one.kfast", "kfast 1\ncanvas 100 100\nobject o stroke=white { line 10 10 90 10 }\n")
        lines = "; ".join(f"line 10 {y} 90 {y}" for y in range(10, 70, 5))
        self.write("twelve.kfast", f"kfast 1\ncanvas 100 100\nobject o stroke=white {{ {lines} }}\n")
        one, twelve = (self.report(f"{name}.kfast", *self.beam_board())["busiest"]["instructions"]
                       for name in ("one", "twelve"))
        self.assertGreater(twelve - one, 150_000)

    def test_the_pico_with_a_beam_plays_the_examples(self):
        self.assertTrue(self.report(ROOT / "examples" / "reference" / "walker.kfast", "--board", "pico-xy")["fits"])

    def test_a_beam_that_hurries_is_told(self):
        self.write("box.kfast", BOX)
        report = self.report("box.kfast", *self.beam_board(beam="scope least-refresh=250 rate=(kHz)60"))
        self.assertEqual(report["hasty"], 6)  # the box grows small enough
        self.assertLessEqual(report["busiest"]["points"], 240)
        self.assertIn("6 pictures of 10 are drawn faster than the profile has it", report["notes"][0])

    def test_hatchings_that_find_no_room_as_told_are_noted(self):
        scene = "kfast 1\ncanvas 240 240 frames=2\nobject o fill=white beam=hatch hatch=0.5 {{ rect {} }}\n"
        self.write("wide.kfast", scene.format("-2000 -2000 4000 4000"))
        self.assertIn("2 pictures of 2 have hatchings with wider spaces than told",
                      " ".join(self.report("wide.kfast", *self.beam_board())["notes"]))
        self.write("wide.kfast", scene.format("20 20 200 200"))
        self.assertNotIn("hatchings", " ".join(self.report("wide.kfast", *self.beam_board())["notes"]))

    def test_lines_that_a_beam_has_no_time_for(self):
        self.write("dots.kfast", DOTS)
        report = self.refused("dots.kfast", *self.beam_board(ram=1024))
        self.assertEqual(report["incomplete"], 2)
        self.assertIn("draw fewer lines, or choose a lower least-refresh= (40 now)", report["reasons"][0])
        self.assertEqual((report["hasty"], report["notes"]), (2, []), "a factor would say nothing")
        self.assertTrue(self.report("dots.kfast", *self.beam_board(ram=1024, clock=1000, beam="scope least-refresh=20", bands="(KiB)20"))["fits"])

    def test_a_beam_with_too_little_memory_time_or_bus(self):
        self.write("box.kfast", BOX)
        self.assertIn("RAM", self.refused("box.kfast", *self.beam_board(ram=24))["reasons"][0])
        self.assertIn("speed", self.refused("box.kfast", *self.beam_board(clock=1), "--fps", "200")["reasons"][0])
        self.assertIn("bus: it takes 588235 points", self.refused("box.kfast", *self.beam_board(beam="scope rate=(kHz)700"))["reasons"][0])
        self.assertIn("a buffer holds 1024 points", self.report("box.kfast", *self.beam_board(bands="(KiB)4"))["notes"][0])

    def test_compile_refuses_what_a_beam_has_no_time_for(self):
        self.write("dots.kfast", DOTS)
        refused = self.run_kfast("compile", "dots.kfast", "-o", "dots.kfb", *self.beam_board(ram=1024), status=1)
        self.assertIn("does not fit bench", refused.stderr)
        self.assertFalse((self.folder / "dots.kfb").exists())

    def test_a_beam_has_no_panel(self):
        self.write("box.kfast", BOX)
        refused = self.run_kfast("fit", "box.kfast", *self.beam_board(), "--panel", "st7789", status=1)
        self.assertIn("has a beam, not a panel", refused.stderr)

    def test_memory_adds_up(self):
        report = self.report("repeat.kfast", *self.board(reserved=1000))
        info = json.loads(self.run_kfast("info", "repeat.kfast", "--json").stdout)
        self.assertEqual(report["ram"]["block"], info["memory"]["bytes"])
        self.assertEqual(report["ram"]["bands"], 2048)
        self.assertEqual(report["ram"]["reserved"], 1000)
        self.assertEqual(report["flash"]["scene"], info["bytes"])
        self.assertGreater(report["flash"]["player"], 4096)
        self.assertGreater(report["ram"]["stack"], 256)
        for memory, available in (("ram", 64 * 1024), ("flash", 256 * 1024)):
            *parts, used, free = report[memory].values()
            self.assertEqual((sum(parts), available), (used, free))

    def test_frames_are_told_in_time_and_bytes(self):
        report = self.report("repeat.kfast", *self.board())
        first, median, worst = (report[name] for name in ("first_picture", "median", "worst"))
        self.assertEqual(first["bytes"], 60 * 40 * 2 + 11 * first["areas"])
        self.assertGreater(first["bytes"], worst["bytes"])
        self.assertGreater(first["instructions"], 0)
        self.assertGreaterEqual(worst["instructions"], median["instructions"])
        self.assertAlmostEqual(worst["bus_ms"], worst["bytes"] / 5e6 * 1000)
        self.assertLessEqual(report["fps"]["bus_worst"], 5e6 / max(worst["bytes"], median["bytes"]) + 1)
        self.assertEqual(worst["object"], "dot")

    def test_a_faster_clock_or_fewer_cycles_take_less_time(self):
        slow = self.report("repeat.kfast", *self.board(clock=50))["worst"]["cpu_ms"]
        fast = self.report("repeat.kfast", *self.board(clock="100 cycles=1"))["worst"]["cpu_ms"]
        self.assertEqual(self.report("repeat.kfast", *self.board(clock=100))["worst"]["cpu_ms"], slow / 2)
        self.assertLess(fast, slow / 2)

    def test_objects_have_the_names_of_all_that_they_lie_in(self):
        (self.folder / "named.kfast").write_text(NAMED)
        self.assertIn(self.report("named.kfast", *self.board())["worst"]["object"], ("face/eye/shape", "still/still"))
        self.run_kfast("compile", "named.kfast")
        self.assertIn(self.report("named.kfb", *self.board())["worst"]["object"], ("object 1", "object 1/object 1"))

    def test_objects_without_tracks_are_told_apart(self):
        for keys in ("rect 8 8 4 4", "key 0 { circle 20 20 r=15 }; key 8 { circle 30 20 r=9 }"):
            (self.folder / "two.kfast").write_text(WITHOUT_TRACKS.format(keys=keys))
            self.assertEqual(self.report("two.kfast", *self.board())["largest_outlines"]["object"], "comb")
            self.run_kfast("compile", "two.kfast")
            self.assertEqual(self.report("two.kfb", *self.board())["largest_outlines"]["object"], "object 1")
        self.assertEqual(self.report("two.kfast", *self.board())["worst"]["object"], "comb")

    def test_too_little_ram_tells_how_much_and_where(self):
        (self.folder / "large.kfast").write_text(MANY_POINTS)
        report = self.refused("large.kfast", *self.board(ram=8))
        excess = report["ram"]["used"] - report["ram"]["available"]
        self.assertGreater(excess, 0)
        reason = next(reason for reason in report["reasons"] if reason.startswith("RAM"))
        self.assertIn(f"{excess} too many", reason)
        self.assertIn("frame 0", reason)
        self.assertIn("are of large", reason)
        outlines = report["largest_outlines"]
        self.assertEqual(outlines["object"], "large")
        self.assertLess(outlines["frame"], 1)
        self.assertLessEqual(outlines["object_bytes"], outlines["bytes"])

    def test_bands_whose_borders_find_no_room_are_counted(self):
        self.assertEqual(self.report("repeat.kfast", *self.board())["unrecorded_bands"], 0)
        bars = "; ".join(f"rect {3 * i} 0 1 40" for i in range(20))
        self.write("bars.kfast", f"kfast 1\ncanvas 60 40 frames=8\nobject bars fill=red {{ {bars}; key 0 x=0; key 8 x=1 }}\n")
        self.assertIn(self.report("bars.kfast", *self.board())["unrecorded_bands"], range(1, 11))

    def test_too_many_objects(self):
        (self.folder / "crowd.kfast").write_text(MANY_OBJECTS)
        report = self.refused("crowd.kfast", *self.board(ram=64, panel="240 240"))
        self.assertIn("too many", report["reasons"][0])
        self.assertRegex(report["reasons"][0], r"are of dot\d+")

    def test_too_little_flash(self):
        report = self.refused("repeat.kfast", *self.board(flash=8))
        excess = report["flash"]["used"] - 8192
        self.assertIn(f"flash: {report['flash']['used']} bytes are needed", report["reasons"][0])
        self.assertIn(f"{excess} too many", report["reasons"][0])

    def test_what_is_reserved_counts(self):
        self.assertTrue(self.report("repeat.kfast", *self.board(reserved=30_000))["fits"])
        self.assertIn("reserved 60000", self.refused("repeat.kfast", *self.board(reserved=60_000))["reasons"][0])

    def test_bands_that_hold_no_row(self):
        self.assertIn("1 row of the panel takes 120", self.refused("repeat.kfast", *self.board(bands="(B)100"))["reasons"][0])
        reason = self.refused("repeat.kfast", *self.board(bands="(B)100", panel="ssd1306"))["reasons"][0]
        self.assertIn("8 rows of the panel take 128", reason)

    def test_too_slow_for_the_frame_rate(self):
        report = self.refused("repeat.kfast", *self.board(clock=1, bus="i2c clock=(kHz)100"))
        self.assertIn("30 fps leave 33.3 ms", report["reasons"][-1])
        self.assertTrue(self.report("repeat.kfast", *self.board(bus="i2c clock=(kHz)800"), "--fps", "1")["fits"])
        self.refused("repeat.kfast", *self.board(clock=24), "--fps", "1000")

    def test_late_frames_and_hasty_buses_are_noted(self):
        report = self.report("repeat.kfast", *self.board(panel="st7735 60 40"))
        self.assertIn("st7735 allows 15.15 MHz on its bus; here it runs at 40 MHz", " ".join(report["notes"]))

    def test_live_drawings_are_played_and_told_within_the_link(self):
        (self.folder / "plot.kfast").write_text(PLOT.format(points=200))
        report = self.report("plot.kfast", *self.board(ram=128))
        self.assertEqual(report["link"], [{"what": "13 numbers", "reports": 2, "per_second": 500},
                                          {"what": "plot, 200 points in 2 strokes", "reports": 14, "per_second": 1000 / 14}])
        self.assertGreater(report["worst"]["instructions"], 3 * report["first_picture"]["instructions"])
        self.assertGreater(report["noise"]["instructions"], report["worst"]["instructions"])
        self.assertEqual(report["worst"]["object"], "trace")
        self.assertEqual(report["notes"], [])
        self.assertIn("  link        plot, 200 points in 2 strokes: 14 reports, up to 71 times a second\n",
                      self.run_kfast("fit", "plot.kfast", *self.board(ram=128)).stdout)
        (self.folder / "plot.kfast").write_text(PLOT.format(points=600))
        report = self.report("plot.kfast", *self.board(ram=600), "--fps", "25", status=1)
        self.assertIn("telling plot, 600 points in 2 strokes takes 41 reports, so that 24.3 fps can be told by USB, not 25 fps",
                      report["notes"])
        (self.folder / "still.kfast").write_text(NAMED)
        report = self.report("still.kfast", *self.board())
        self.assertEqual((report["link"], report["noise"]), ([], None))

    def test_for_people(self):
        told = self.run_kfast("fit", "repeat.kfast", *self.board()).stdout
        for row in ("scene", "block", "firmware", "first", "median", "worst", "by CPU", "by bus", "fits        yes"):
            self.assertIn(row, told)
        told = self.run_kfast("fit", "repeat.kfast", *self.board(ram=2), status=1).stdout
        self.assertIn("fits        no", told)

    def test_the_scene_stands_apart_from_the_firmware(self):
        report = self.report("repeat.kfast", "--board", "pico")
        flash, ram, room = report["flash"], report["ram"], report["room"]
        self.assertEqual(room, {"scene": 256 * 1024, "block": ram["available"] - ram["used"] + ram["block"]})
        self.assertEqual([part["name"] for part in report["reserved"]], ["code and drivers", "slots"])
        for memory, total in (("flash", flash["reserved"]), ("ram", ram["reserved"])):
            self.assertEqual(sum(part[memory] for part in report["reserved"]), total)
        printed = self.run_kfast("fit", "repeat.kfast", "--board", "pico").stdout
        self.assertIn(f"  scene       {flash['scene']} B of 256 KiB for scenes\n  block       ", printed)
        self.assertRegex(printed, r"  firmware    1.75 MiB of 2 MiB of flash: player [\d.]+ KiB, code and drivers [\d.]+ KiB, slots 1.5 MiB\n"
                               r"  +[\d.]+ KiB of 264 KiB of RAM: bands 30 KiB, static [\d.]+ K?i?B, stack [\d.]+ KiB, code and drivers")

    def test_pictures_that_are_late(self):
        self.write("jump.kfast", "kfast 1\ncanvas 60 40 frames=30\nobject a fill=red {\n"
                                 "    key 0 law=hold { rect 0 0 2 2 }; key 15 { rect 0 0 60 40 } }\n")
        report = self.report("jump.kfast", *self.board(bus="i2c clock=(kHz)800"))
        self.assertTrue(report["fits"])
        self.assertEqual(report["late"], {"frames": 30, "late": 2, "left_out": 0})
        self.assertIsNone(report["late_with_inputs"])
        printed = self.run_kfast("fit", "jump.kfast", *self.board(bus="i2c clock=(kHz)800")).stdout
        self.assertIn("  fits        yes, but 2 of 30 pictures late\n", printed)
        report = self.report("jump.kfast", *self.board(bus="i2c clock=(kHz)200"))
        self.assertEqual(report["late"], {"frames": 30, "late": 12, "left_out": 10})

    def test_pictures_that_are_late_where_inputs_leap(self):
        self.write("knob.kfast", "kfast 1\ncanvas 60 40 frames=64\ninput knob\n"
                                 "object a fill=red { rect 0 0 9 40; track x input=knob { at 0 0; at 1 51 } }\n")
        told = self.run_kfast("fit", "knob.kfast", *self.board(bus="i2c clock=(kHz)350")).stdout
        self.assertRegex(told, r"(?m)^  fits        yes, but late while its inputs leap: at worst 22.3 fps of 30 fps$")
        told = self.run_kfast("fit", "knob.kfast", *self.board()).stdout
        self.assertRegex(told, r"(?m)^  fits        yes, at [\d.]+ fps$")

    def test_no_rate_that_nobody_sees(self):
        printed = self.run_kfast("fit", "repeat.kfast", *self.board(bus="parallel-16 clock=(MHz)60")).stdout
        self.assertIn("by bus      more than 1000 fps\n", printed)

    def test_hardware_that_is_not_supported_yet(self):
        self.refuse("fit", "repeat.kfast", "--board", "pico2", status=1,
                    says="a Pico 2 (RP2350, Cortex-M33) is not supported yet")
        printed = self.run_kfast("fit", "repeat.kfast", "--board", "ESP32-S3", status=1).stderr
        self.write("my-esp32s3.kdl", printed[printed.index("board my-esp32s3 {"):])
        self.assertEqual(self.report("repeat.kfast", "--board", "my-esp32s3.kdl")["board"], "my-esp32s3")
        self.refuse("fit", "repeat.kfast", "--board", "uno", status=1, says="take a board of 32 bits")
        self.refuse("fit", "repeat.kfast", *self.board(), "--panel", "sh1106", status=2, says="pages of 8 rows")
        self.refuse("preview", "repeat.kfast", "--headless", "--board", "pico2", status=1, says="Pico 2")

    def test_one_list_of_panels(self):
        """The page, fit, the preview's commands and settings: the same, but for those that are for fit alone."""
        page = (ROOT / "docs" / "fit.md").read_text().split("### Panels")[1]
        rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in page.splitlines() if line.startswith("| `")]
        self.assertGreater(len(rows), 8)
        names = {row[0].strip("`"): row[1:] for row in rows if re.fullmatch(r"`\w+`", row[0]) and "x" in row[1]}
        fit_help = self.run_kfast("fit", "--help").stdout
        for name, (size, *_, driver) in names.items():
            panel = self.report("repeat.kfast", "--board", "pico", "--panel", name)["panel"]
            self.assertEqual(f"{panel['width']}x{panel['height']}", size)
            self.assertIn(name, fit_help)
            self.write("settings.kdl", f"board pico {{ panel {name}; bus spi; pins clock=18 data=19 select=17 dc=16 reset=20 }}")
            if driver == "yes":
                self.run_kfast("render", "repeat.kfast", "--panel", name, "-o", f"{name}.png")
                self.run_kfast("config", "settings.kdl", "-o", f"{name}.uf2")
            else:
                self.assertEqual(driver, "for `fit` alone")
                self.refuse("render", "repeat.kfast", "--panel", name, "-o", f"{name}.png", status=2,
                            says=f"kfast fit alone knows it, for it has no driver yet; its picture is that of --size {size}")
                self.refuse("config", "settings.kdl", "-o", f"{name}.uf2", status=1, says="kfast fit alone knows it")
        printed = self.run_kfast("fit", "repeat.kfast", "--board", "pico", "--panel", "zzzzzzzz", status=2).stderr
        self.assertIn("allowed: " + ", ".join(sorted(names)), printed)

    def test_known_boards_and_panels(self):
        for board in ("blackpill", "lm3s6965evb", "pico"):
            self.report(ROOT / "examples/robot-eyes.kfast", "--board", board)
        for board in ("blackpill", "lm3s6965evb", "pico"):
            self.assertEqual(self.report("repeat.kfast", "--board", board)["notes"], [])
        (self.folder / "crowd.kfast").write_text(MANY_OBJECTS)
        refused = self.refused("crowd.kfast", "--board", "bluepill")
        for memory in ("flash", "RAM"):
            self.assertTrue(any(reason.startswith(memory) for reason in refused["reasons"]), refused["reasons"])
        report = self.report("repeat.kfast", "--board", "pico", "--panel", "ssd1351")
        self.assertEqual(report["panel"], {"name": "ssd1351", "width": 128, "height": 128, "format": "rgb565"})

    def test_wrong_boards(self):
        self.refuse("fit", "repeat.kfast", "--board", "pica", status=1, says='did you mean "pico"?')
        self.refuse("fit", "repeat.kfast", "--board", "none.kdl", status=1, says="none.kdl: there is no such file")
        self.board(core="cortex-m5")
        self.refuse("fit", "repeat.kfast", "--board", "desk.kdl", status=1, says="desk.kdl:2:10: error")
        self.refuse("fit", "repeat.kfast", "--board", "./repeat.kfast", status=1, says="one node")
        self.refuse("fit", "repeat.kfast", status=2, says="--board is required")
        self.refuse("fit", "repeat.kfast", *self.board(), "--panel", "st7788", status=2, says='did you mean "st7789"?')
        self.refuse("fit", "repeat.kfast", *self.board(), "--fps", "0", status=2, says="--fps")
        self.refuse("compile", "repeat.kfast", "--fps", "20", status=2, says="--board")

    def test_compile_refuses_what_does_not_fit(self):
        self.board(ram=2)
        self.refuse("compile", "repeat.kfast", "--board", "desk.kdl", status=1, says="RAM:")
        self.assertFalse((self.folder / "repeat.kfb").exists())
        self.board()
        self.run_kfast("compile", "repeat.kfast", "--board", "desk.kdl")
        self.assertTrue((self.folder / "repeat.kfb").exists())


if __name__ == "__main__":
    unittest.main()
