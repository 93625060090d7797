"""Right and wrong usage of the real command."""

import json
import os
import re
import subprocess
import unittest

from command_case import KFAST, ROOT, CommandTest, kfast


class UsageTest(CommandTest):
    def test_help_everywhere(self):
        example = re.search(r"Example:\n  kfast preview (\S+)", self.run_kfast("--help").stdout)
        self.assertTrue((ROOT / example[1]).is_file(), "the first example can be typed as it stands")
        for command in ("compile", "check", "help", "info", "render", "preview", "hash", "export", "config", "wiring", "uf2 pack", "flash",
                        "devices", "play", "live", "pause", "resume", "seek", "speed", "brightness", "upload", "slots",
                        "choose", "erase", "boot", "schema", "completions", "man"):
            self.assertIn(f"  kfast {command} ", self.run_kfast(*command.split(), "--help").stdout)

    def test_values_have_names(self):
        for command in re.findall(r"^  ([a-z][a-z0-9-]*) {2,}", self.run_kfast("--help").stdout, re.MULTILINE):
            for line in self.run_kfast(command, "--help").stdout.splitlines():
                self.assertNotRegex(line, r"^ +-\S+ (TEXT|INT|UINT|FLOAT)", command)

    def test_version(self):
        for flag in ("--version", "-V", "-v"):
            self.assertRegex(self.run_kfast(flag).stdout, r"^kfast \d+\.\d+\.\d+\n$")

    def test_help_is_a_command_too(self):
        for command in ((), ("render",), ("uf2", "pack"), ("help",)):
            self.assertEqual(self.run_kfast("help", *command).stdout, self.run_kfast(*command, "--help").stdout)
        self.refuse("help", "rendr", status=2, says='there is no command \'rendr\': did you mean "render"?')
        self.refuse("help", "uf2", "pck", status=2, says='did you mean "pack"?')

    def test_velocity_laws_have_a_help_of_their_own(self):
        page = self.run_kfast("help", "laws").stdout
        self.assertIn("bounce-in-out(n)", page)
        self.assertNotIn("\x1b", page)
        self.assertLessEqual(max(map(len, page.splitlines())), 80)

    def test_boards_and_panels_are_listed(self):
        boards = {row["name"]: row for row in json.loads(self.run_kfast("boards", "--json").stdout)}
        self.assertEqual(boards["pico"]["panel"], {"name": "st7789", "width": 240, "height": 240, "format": "rgb565"})
        self.assertIn("beam", boards["pico-xy"])
        listed = self.run_kfast("boards").stdout.splitlines()
        self.assertRegex(listed[0], "^BOARD +PROCESSOR +FLASH +RAM +BUS +DISPLAY$")
        self.assertEqual([line.split()[0] for line in listed[1:]], list(boards))
        self.assertIn("pico cortex-m0+, 125 MHz 2 MiB 264 KiB spi, 62.5 MHz st7789 240x240, 65536 colours",
                      [re.sub(" +", " ", line) for line in listed])
        for name in boards:
            self.assertIn(kfast("fit", "repeat.kfast", "--board", name, folder=self.folder).returncode, (0, 1))
        panels = {row["name"]: row for row in json.loads(self.run_kfast("panels", "--json").stdout)}
        self.assertEqual(panels["ssd1322"]["format"], "grey4")
        self.assertFalse(panels["ssd1322"]["draw"] or panels["ssd1322"]["flash"])
        self.assertTrue(panels["ili9341-parallel"]["flash"])
        for row in panels.values():
            for known, command in (("draw", ("hash", "repeat.kfast")), ("fit", ("fit", "repeat.kfast", "--board", "pico"))):
                self.assertEqual(kfast(*command, "--panel", row["name"], folder=self.folder).returncode != 2, row[known])
        listed = self.run_kfast("panels").stdout.splitlines()
        self.assertEqual([line.split()[0] for line in listed[1:]], sorted(panels))
        self.assertRegex("\n".join(listed), r"\nssd1306 +128x64 +black and white +spi, i2c +render, preview, panel, fit, flash\n")

    def test_help_is_for_people(self):
        shown = self.run_kfast("render", "--help").stdout
        for internal in ("[Option", "At most", "Excludes", "NUMBER from", "REQUIRED"):
            self.assertNotIn(internal, shown)
        self.assertIn("Each pixel as a square of so many a side (1 to 64)", shown)
        self.assertRegex(shown, r"-o, --output OUT  +A \.png .* \(needed\)")
        headings = re.findall(r"(?m)^([A-Z].*):$", shown)
        self.assertEqual(headings[:3], ["Arguments", "What to draw (one of these; default: frame 0, or all of an animation or a "
                                        "video)", "Where to write it, and how"])
        self.assertEqual(headings[-2:], ["Options", "Example"])
        self.assertIn("Seconds to wait for a device that is silent (0.1 to 3600; default: 10)", self.run_kfast("play", "--help").stdout)

    def test_help_on_a_terminal_has_headings_in_colour_and_short_lines(self):
        for variables, is_coloured in (({"NO_COLOR": ""}, True), ({"NO_COLOR": "1"}, False)):
            shown = self.written_to_a_terminal("render", "--help", stream="stdout", environment=variables)
            self.assertEqual("\x1b[1;36mWhat to play:\x1b[0m" in shown, is_coloured)
            self.assertEqual("\x1b" in shown, is_coloured)
            texts = [line for line in re.sub(r"\x1b\[[0-9;]*m", "", shown).splitlines() if line.startswith("  -")]
            self.assertLessEqual(max(map(len, texts)), 80)
        self.assertNotIn("\x1b", self.run_kfast("render", "--help").stdout)

    def test_wrong_usage(self):
        self.refuse(status=2, says="a command is missing")
        self.refuse("hsh", "repeat.kfast", status=2, says='did you mean "hash"?')
        listed = self.run_kfast("frobnicate", status=2).stderr
        self.assertRegex(listed, r"there is no command 'frobnicate': allowed: new, .*, boards, panels, .*, help\nTry")
        self.refuse("hsh", "repeat.kfast", "--size", "9x9", status=2, says='did you mean "hash"?\nTry \'kfast --help\'.')
        self.refuse("uf2", "pck", "--config", "a", status=2, says='did you mean "pack"?')
        self.refuse("hash", status=2, says="FILE is required")
        self.refuse("hash", "repeat.kfast", "--frobnicate", status=2, says="--frobnicate")
        self.refuse("hash", "repeat.kfast", "extra", status=2, says="extra")
        self.refuse("export", "repeat.kfast", status=2, says="kfast: choose one of --header, --ild, --wav\n")
        self.refuse("render", "repeat.kfast", "--all", "--contact", "-o", "a.png", status=2,
                    says="kfast: choose one of --frame, --time, --all, --sheet, --contact\n")

    def test_an_option_that_there_is_not_is_told_first(self):
        self.refuse("render", "nothing.kfast", "--scal", "3", status=2, says='no option --scal: did you mean "--scale"?')
        self.refuse("render", "repeat.kfast", "--frme=3", status=2, says='did you mean "--frame"?')
        self.refuse("hash", "repeat.kfast", "--size", "3", "--qqq", status=2, says="no option --qqq: allowed: --")
        self.refuse("render", "repeat.kfast", "--all", "-f", "gif", status=2, says="no option -f: allowed: -o, -q, -h\n")
        self.refuse("render", "repeat.kfast", "--frame", "-1", status=2, says="--output is required")
        self.refuse("--vesion", status=2, says='did you mean "--version"?')
        self.refuse("uf2", "pack", "--firmwear", "a.bin", status=2, says='did you mean "--firmware"?')
        self.refuse("info", "--", "--no-file", status=1, says="--no-file: there is no such file")

    def test_old_names_of_options_work_with_a_note(self):
        page = (ROOT / "docs/commands.md").read_text(encoding="utf-8").split("### Old names")[1]
        rows = re.findall(r"(?m)^\| (`.*`) \| `(.*)` \| `(.*)` \|$", page)
        self.assertGreater(len(rows), 10)
        values = {"--fit": "cover", "--size": "9x9", "--rate": "9000"}
        for commands, before, now in rows:
            for command in re.findall(r"`(\w+)`", commands):
                printed = self.run_kfast(command, *before.split(), values.get(before, "x"), "--help")
                self.assertIn(f"kfast: {before} is now called {now}; the next version drops the old name", printed.stderr)
                self.assertNotRegex(printed.stdout, rf"{before.split()[0]}\b(?!-)")
        printed = self.run_kfast("check", "--format", "text", "repeat.kfast")
        self.assertEqual(printed.stdout, self.run_kfast("check", "repeat.kfast").stdout)
        self.assertEqual(printed.stderr, "kfast: --format text is the default; the next version drops the option\n")
        shown = self.run_kfast("hash", "repeat.kfast", "--size", "64x32", "--fit=cover").stdout
        self.assertEqual(shown, self.run_kfast("hash", "repeat.kfast", "--size", "64x32", "--scaling", "cover").stdout)
        self.assertNotEqual(shown, self.run_kfast("hash", "repeat.kfast", "--size", "64x32").stdout)

    def test_whole_numbers(self):
        for arguments in (["render", "repeat.kfast", "--frame", "1e3", "-o", "a.png"],
                          ["render", "repeat.kfast", "--all", "--scale", "1.5", "-o", "a.gif"]):
            self.refuse(*arguments, status=2, says=f'{arguments[-4]}: "{arguments[-3]}" is no whole number: write digits')
        self.refuse("erase", "1", "x", status=2, says='"x" is no whole number')
        for slot in ("300", "-1"):
            self.refuse("play", f"--slot={slot}", status=2, says=f"--slot: {slot} is out of range")

    def test_outputs_have_names(self):
        for command in (["compile", "repeat.kfast"], ["render", "repeat.kfast", "--all"],
                        ["export", "--header", "repeat.kfast"], ["uf2", "unpack", "repeat.kfast"]):
            self.refuse(*command, "-o", "", status=2, says="--output: the name is empty: say where to write")
            self.refuse(*command, "-o", "-", status=2, says="standard output is not written to: say where to write")

    def test_what_another_command_makes_is_not_compiled(self):
        for name, remedy in (("hello.h", "for a header: kfast export --header repeat.kfast -o hello.h"), ("hello.cpp", "export --header"),
                             ("hello.H", "kfast export --header"),
                             ("hello.gif", "kfast render"), ("hello.uf2", "kfast uf2 pack --scene")):
            self.refuse("compile", "repeat.kfast", "-o", name, status=2, says=remedy)
            self.assertFalse((self.folder / name).exists())
        for name in ("hello", "hello.bin", "hello.kfb"):
            self.run_kfast("compile", "repeat.kfast", "-o", name)

    def test_options_for_files_of_other_programs(self):
        self.run_kfast("compile", "repeat.kfast")
        for option, value in (("--canvas", "30x30"), ("--background", "navy"), ("--tolerance", "1"), ("--animation", "a")):
            for scene in ("repeat.kfast", "repeat.kfb"):
                self.refuse("fit", scene, "--board", "pico", option, value, status=2,
                            says=f"{scene}: {option} is for files of other programs")
        self.run_kfast("check", "repeat.kfast", "--strict")

    def test_a_closed_output_is_a_failure_and_closed_messages_are_none(self):
        for number, status in ((1, 1), (2, 0)):
            result = subprocess.run([KFAST, "info", "repeat.kfast"], cwd=self.folder, stdout=subprocess.DEVNULL, timeout=120,
                                    preexec_fn=lambda number=number: os.close(number))
            self.assertEqual(result.returncode, status)

    def test_wrong_pictures(self):
        scene = ["hash", "repeat.kfast"]
        for size in ("0x1", "1x0", "4097x1", "1x4097", "3", "3x", "x3", "3x3x3", "-3x3", "3 x 3", "99999999999x1"):
            self.refuse(*scene, f"--size={size}", status=2, says="write it like 240x135")
        self.refuse(*scene, "--scaling", "containt", status=2, says='did you mean "contain"?')
        self.refuse(*scene, "--format", "rgb888", status=2, says="rgb565")
        self.refuse(*scene, "--panel", "sdd0323", status=2, says="ssd0323")
        for option, value in (("--size", "9x9"), ("--scaling", "none"), ("--format", "mono1")):
            self.refuse(*scene, "--panel", "ssd0323", option, value, status=2, says="--panel")

    def test_the_largest_picture(self):
        self.run_kfast("render", "repeat.kfast", "--frame", "0", "--size", "4096x4096", "--format", "mono1", "-o", "a.png")


if __name__ == "__main__":
    unittest.main()
