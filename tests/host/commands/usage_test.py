"""Right and wrong usage of the real command."""

import os
import re
import subprocess
import unittest

from command_case import KFAST, ROOT, CommandTest


class UsageTest(CommandTest):
    def test_help_everywhere(self):
        example = re.search(r"Example:\n  kfast preview (\S+)", self.run_kfast("--help").stdout)
        self.assertTrue((ROOT / example[1]).is_file(), "the first example can be typed as it stands")
        for command in ("compile", "check", "info", "render", "preview", "hash", "export", "config", "wiring", "uf2 pack", "flash",
                        "devices", "play", "live", "pause", "resume", "seek", "speed", "brightness", "upload", "slots",
                        "choose", "erase", "boot", "schema", "completions", "man"):
            self.assertIn(f"  kfast {command} ", self.run_kfast(*command.split(), "--help").stdout)

    def test_values_have_names(self):
        for command in re.findall(r"^  ([a-z][a-z0-9-]*) {2,}", self.run_kfast("--help").stdout, re.MULTILINE):
            for line in self.run_kfast(command, "--help").stdout.splitlines():
                self.assertNotRegex(line, r"^ +-\S+ (TEXT|INT|UINT|FLOAT)", command)

    def test_version(self):
        self.assertRegex(self.run_kfast("--version").stdout, r"^kfast \d+\.\d+\.\d+\n$")

    def test_wrong_usage(self):
        self.refuse(status=2, says="a command is missing")
        self.refuse("hsh", "repeat.kfast", status=2, says='did you mean "hash"?')
        self.refuse("hsh", "repeat.kfast", "--size", "9x9", status=2, says='did you mean "hash"?\nTry \'kfast --help\'.')
        self.refuse("uf2", "pck", "--config", "a", status=2, says='did you mean "pack"?')
        self.refuse("hash", status=2, says="FILE is required")
        self.refuse("hash", "repeat.kfast", "--frobnicate", status=2, says="--frobnicate")
        self.refuse("hash", "repeat.kfast", "extra", status=2, says="extra")

    def test_an_option_that_there_is_not_is_told_first(self):
        self.refuse("render", "nothing.kfast", "--scal", "3", status=2, says='no option --scal: did you mean "--scale"?')
        self.refuse("render", "repeat.kfast", "--frme=3", status=2, says='did you mean "--frame"?')
        self.refuse("hash", "repeat.kfast", "--size", "3", "--qqq", status=2, says="no option --qqq: allowed: --")
        self.refuse("render", "repeat.kfast", "--all", "-f", "gif", status=2, says="no option -f: allowed: -h, -o\n")
        self.refuse("render", "repeat.kfast", "--frame", "-1", status=2, says="--output is required")
        self.refuse("--vesion", status=2, says='did you mean "--version"?')
        self.refuse("uf2", "pack", "--firmwear", "a.bin", status=2, says='did you mean "--firmware"?')
        self.refuse("info", "--", "--no-file", status=1, says="--no-file: there is no such file")

    def test_old_names_of_options_work_with_a_note(self):
        page = (ROOT / "docs/commands.md").read_text(encoding="utf-8").split("### Old names")[1]
        rows = re.findall(r"(?m)^\| (`.*`) \| `(.*)` \| `(.*)` \|$", page)
        self.assertGreater(len(rows), 10)
        for commands, before, now in rows:
            for command in re.findall(r"`(\w+)`", commands):
                told = self.run_kfast(command, *before.split(), "x" if before.startswith("--f") else "9", "--help")
                self.assertIn(f"kfast: {before} is now called {now}; the old name goes with the next version", told.stderr)
                self.assertNotRegex(told.stdout, rf"{before.split()[0]}\b(?!-)")
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
